// A Vulkan layer that lets a device fail as told, whatever the device:
//   MORPHGRID_FAILING_DEVICE_SUBMITS  so many submissions work, then the device is lost
//   MORPHGRID_FAILING_DEVICE_BYTES    no allocation is larger
// One instance and one device at a time, as in the program.
#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>

namespace {

PFN_vkGetInstanceProcAddr nextInstanceProcAddr = nullptr;
PFN_vkGetDeviceProcAddr nextDeviceProcAddr = nullptr;
VkInstance instance = VK_NULL_HANDLE;
VkDevice device = VK_NULL_HANDLE;
long submissions = 0;

/// No limit where the environment sets none.
long limitOf(const char* variable) {
  const char* const text = std::getenv(variable);
  return text ? std::atol(text) : std::numeric_limits<long>::max();
}

template <typename Info>
Info* linkOf(const void* createInfo, VkStructureType type) {
  for (auto* info = static_cast<const Info*>(createInfo); info;
       info = static_cast<const Info*>(info->pNext)) {
    if (info->sType == type && info->function == VK_LAYER_LINK_INFO) {
      return const_cast<Info*>(info);
    }
  }
  return nullptr;
}

bool isLost() { return submissions > limitOf("MORPHGRID_FAILING_DEVICE_SUBMITS"); }

template <typename Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(nextDeviceProcAddr(device, name));
}

VKAPI_ATTR VkResult VKAPI_CALL queueSubmit(VkQueue queue, std::uint32_t count,
                                           const VkSubmitInfo* submits, VkFence fence) {
  ++submissions;
  return isLost() ? VK_ERROR_DEVICE_LOST
                  : next<PFN_vkQueueSubmit>("vkQueueSubmit")(queue, count, submits, fence);
}

VKAPI_ATTR VkResult VKAPI_CALL waitForFences(VkDevice of, std::uint32_t count,
                                             const VkFence* fences, VkBool32 all,
                                             std::uint64_t timeout) {
  return isLost() ? VK_ERROR_DEVICE_LOST
                  : next<PFN_vkWaitForFences>("vkWaitForFences")(of, count, fences, all, timeout);
}

VKAPI_ATTR VkResult VKAPI_CALL allocateMemory(VkDevice of, const VkMemoryAllocateInfo* info,
                                              const VkAllocationCallbacks* callbacks,
                                              VkDeviceMemory* memory) {
  const auto limit = static_cast<VkDeviceSize>(limitOf("MORPHGRID_FAILING_DEVICE_BYTES"));
  return info->allocationSize > limit
             ? VK_ERROR_OUT_OF_DEVICE_MEMORY
             : next<PFN_vkAllocateMemory>("vkAllocateMemory")(of, info, callbacks, memory);
}

VKAPI_ATTR VkResult VKAPI_CALL createInstance(const VkInstanceCreateInfo* info,
                                              const VkAllocationCallbacks* callbacks,
                                              VkInstance* created) {
  auto* const link =
      linkOf<VkLayerInstanceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
  nextInstanceProcAddr = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
  link->u.pLayerInfo = link->u.pLayerInfo->pNext;
  const auto create = reinterpret_cast<PFN_vkCreateInstance>(
      nextInstanceProcAddr(VK_NULL_HANDLE, "vkCreateInstance"));
  const VkResult result = create(info, callbacks, created);
  instance = *created;
  return result;
}

VKAPI_ATTR VkResult VKAPI_CALL createDevice(VkPhysicalDevice physical,
                                            const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* callbacks,
                                            VkDevice* created) {
  auto* const link =
      linkOf<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
  nextDeviceProcAddr = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
  link->u.pLayerInfo = link->u.pLayerInfo->pNext;
  const auto create =
      reinterpret_cast<PFN_vkCreateDevice>(nextInstanceProcAddr(instance, "vkCreateDevice"));
  const VkResult result = create(physical, info, callbacks, created);
  device = *created;
  return result;
}

PFN_vkVoidFunction ours(const char* name);

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL deviceProcAddr(VkDevice of, const char* name) {
  const PFN_vkVoidFunction found = ours(name);
  return found ? found : nextDeviceProcAddr(of, name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL instanceProcAddr(VkInstance of, const char* name) {
  const PFN_vkVoidFunction found = ours(name);
  return found ? found : nextInstanceProcAddr(of, name);
}

PFN_vkVoidFunction ours(const char* name) {
  const struct {
    const char* name;
    PFN_vkVoidFunction function;
  } functions[] = {
      {"vkGetInstanceProcAddr", reinterpret_cast<PFN_vkVoidFunction>(instanceProcAddr)},
      {"vkGetDeviceProcAddr", reinterpret_cast<PFN_vkVoidFunction>(deviceProcAddr)},
      {"vkCreateInstance", reinterpret_cast<PFN_vkVoidFunction>(createInstance)},
      {"vkCreateDevice", reinterpret_cast<PFN_vkVoidFunction>(createDevice)},
      {"vkQueueSubmit", reinterpret_cast<PFN_vkVoidFunction>(queueSubmit)},
      {"vkWaitForFences", reinterpret_cast<PFN_vkVoidFunction>(waitForFences)},
      {"vkAllocateMemory", reinterpret_cast<PFN_vkVoidFunction>(allocateMemory)},
  };
  for (const auto& candidate : functions) {
    if (std::strcmp(candidate.name, name) == 0) {
      return candidate.function;
    }
  }
  return nullptr;
}

}  // namespace

extern "C" VK_LAYER_EXPORT VKAPI_ATTR VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* interface) {
  interface->loaderLayerInterfaceVersion = 2;
  interface->pfnGetInstanceProcAddr = instanceProcAddr;
  interface->pfnGetDeviceProcAddr = deviceProcAddr;
  interface->pfnGetPhysicalDeviceProcAddr = nullptr;
  return VK_SUCCESS;
}
