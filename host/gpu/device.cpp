#include "gpu/device.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

#include "core/error.h"
#include "gpu/kernel_profile.h"
#include "gpu/submission_pace.h"
#include "gpu/vulkan_device.h"
#include "gpu/vulkan_program.h"

namespace morphgrid {
namespace {

constexpr std::uint32_t kApiVersion = VK_API_VERSION_1_2;
constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";
constexpr const char* kNoDeviceAdvice =
    "install a driver for your GPU, or the software device: apt-get install mesa-vulkan-drivers";

VKAPI_ATTR VkBool32 VKAPI_CALL collectMessage(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                              VkDebugUtilsMessageTypeFlagsEXT,
                                              const VkDebugUtilsMessengerCallbackDataEXT* data,
                                              void* messages) {
  static std::mutex collecting;  // Kernels are compiled on many threads.
  const std::lock_guard lock(collecting);
  static_cast<std::vector<std::string>*>(messages)->emplace_back(data->pMessage);
  return VK_FALSE;
}

vk::raii::Context loadVulkan() {
  try {
    return vk::raii::Context();
  } catch (const std::exception& error) {
    throw DeviceError(fmt::format("the Vulkan loader cannot be used ({}); {}", error.what(),
                                  "apt-get install libvulkan1 mesa-vulkan-drivers"));
  }
}

bool hasLayer(const vk::raii::Context& context, std::string_view name) {
  const auto layers = context.enumerateInstanceLayerProperties();
  return std::any_of(layers.begin(), layers.end(),
                     [&](const auto& layer) { return name == layer.layerName.data(); });
}

vk::raii::Instance createInstance(const vk::raii::Context& context, bool validation,
                                  const std::optional<Presentation>& presentation = {}) {
  const vk::ApplicationInfo application("morphgrid", 1, nullptr, 0, kApiVersion);
  std::vector<const char*> layers;
  std::vector<const char*> extensions;
  if (presentation) {
    for (const std::string& extension : presentation->instanceExtensions) {
      extensions.push_back(extension.c_str());
    }
  }
  const vk::ValidationFeatureEnableEXT synchronization =
      vk::ValidationFeatureEnableEXT::eSynchronizationValidation;
  const vk::ValidationFeaturesEXT features(synchronization);
  if (validation) {
    if (!hasLayer(context, kValidationLayer)) {
      throw DeviceError(
          "the Vulkan validation layers are not installed: apt-get install "
          "vulkan-validationlayers");
    }
    layers.push_back(kValidationLayer);
    extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
  }
  try {
    return {context, vk::InstanceCreateInfo({}, &application, layers, extensions,
                                            validation ? &features : nullptr)};
  } catch (const vk::SystemError& error) {
    throw DeviceError(
        fmt::format("Vulkan cannot be started ({}); {}", error.what(), kNoDeviceAdvice));
  }
}

vk::raii::DebugUtilsMessengerEXT createMessenger(const vk::raii::Instance& instance,
                                                 bool validation,
                                                 std::vector<std::string>* messages) {
  if (!validation) {
    return nullptr;
  }
  using Severity = vk::DebugUtilsMessageSeverityFlagBitsEXT;
  using Type = vk::DebugUtilsMessageTypeFlagBitsEXT;
  return {instance, vk::DebugUtilsMessengerCreateInfoEXT({}, Severity::eWarning | Severity::eError,
                                                         Type::eValidation | Type::ePerformance,
                                                         collectMessage, messages)};
}

std::vector<vk::raii::PhysicalDevice> physicalDevices(const vk::raii::Instance& instance) {
  std::vector<vk::raii::PhysicalDevice> devices;
  try {
    devices = instance.enumeratePhysicalDevices();
  } catch (const vk::SystemError& error) {
    throw DeviceError(
        fmt::format("Vulkan devices cannot be listed ({}); {}", error.what(), kNoDeviceAdvice));
  }
  if (devices.empty()) {
    throw DeviceError(fmt::format("there is no Vulkan device; {}", kNoDeviceAdvice));
  }
  return devices;
}

std::string versionText(std::uint32_t version) {
  return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version),
                     VK_API_VERSION_PATCH(version));
}

std::string typeText(vk::PhysicalDeviceType type) {
  switch (type) {
    case vk::PhysicalDeviceType::eDiscreteGpu:
      return "discrete GPU";
    case vk::PhysicalDeviceType::eIntegratedGpu:
      return "integrated GPU";
    case vk::PhysicalDeviceType::eVirtualGpu:
      return "virtual GPU";
    case vk::PhysicalDeviceType::eCpu:
      return "CPU";
    default:
      return "other";
  }
}

std::optional<std::uint32_t> generalQueueFamily(const vk::raii::PhysicalDevice& device) {
  const auto families = device.getQueueFamilyProperties();
  constexpr auto kWanted = vk::QueueFlagBits::eCompute | vk::QueueFlagBits::eGraphics;
  for (std::uint32_t n = 0; n < families.size(); ++n) {
    if ((families[n].queueFlags & kWanted) == kWanted) {
      return n;
    }
  }
  return std::nullopt;
}

bool hasSwapchain(const vk::raii::PhysicalDevice& device) {
  const auto extensions = device.enumerateDeviceExtensionProperties();
  return std::any_of(extensions.begin(), extensions.end(), [](const auto& extension) {
    return std::string_view(extension.extensionName.data()) == VK_KHR_SWAPCHAIN_EXTENSION_NAME;
  });
}

bool canPresent(const vk::raii::Instance& instance, const vk::raii::PhysicalDevice& device,
                const Presentation& presentation) {
  return hasSwapchain(device) &&
         presentation.isSupported(*instance, *device, *generalQueueFamily(device));
}

/// Empty when the device can run morphgrid, else what it lacks.
std::string shortcoming(const vk::raii::Instance& instance, const vk::raii::PhysicalDevice& device,
                        const std::optional<Presentation>& presentation) {
  const auto properties = device.getProperties();
  if (properties.apiVersion < kApiVersion) {
    return fmt::format("it offers Vulkan {}, morphgrid needs {} or later",
                       versionText(properties.apiVersion), versionText(kApiVersion));
  }
  if (!generalQueueFamily(device)) {
    return "it has no queue for both compute and graphics";
  }
  if (presentation && !canPresent(instance, device, *presentation)) {
    return "it cannot draw into a window of this display, which `morphgrid run` does not need";
  }
  return {};
}

std::string toLower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool isSelected(std::size_t index, const std::string& name, const std::string& selection) {
  std::size_t wanted = 0;
  const char* end = selection.data() + selection.size();
  const auto [rest, error] = std::from_chars(selection.data(), end, wanted);
  if (error == std::errc() && rest == end) {
    return wanted == index;
  }
  return toLower(name).find(toLower(selection)) != std::string::npos;
}

vk::raii::PhysicalDevice selectDevice(const vk::raii::Instance& instance,
                                      const DeviceOptions& options) {
  const std::string& selection = options.selection;
  const auto devices = physicalDevices(instance);
  std::vector<std::string> others, reasons;
  for (std::size_t n = 0; n < devices.size(); ++n) {
    const std::string name = devices[n].getProperties().deviceName.data();
    if (!isSelected(n, name, selection)) {
      others.push_back(fmt::format("{} {}", n, name));
      continue;
    }
    const std::string reason = shortcoming(instance, devices[n], options.presentation);
    if (reason.empty()) {
      return devices[n];
    }
    reasons.push_back(fmt::format("{} {}: {}", n, name, reason));
  }
  if (reasons.empty()) {
    throw DeviceError(
        fmt::format("no Vulkan device matches --device {}: there is {}; give an index or a part of "
                    "a name from `morphgrid devices`",
                    selection, fmt::join(others, ", ")));
  }
  throw DeviceError(fmt::format(
      "no Vulkan device {}will do ({}); {}",
      selection.empty() ? "" : fmt::format("that matches --device {} ", selection),
      fmt::join(reasons, "; "),
      others.empty() ? kNoDeviceAdvice : fmt::format("there is also {}", fmt::join(others, ", "))));
}

std::uint32_t subgroupSizeOf(const vk::raii::PhysicalDevice& device) {
  return device
      .getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceSubgroupProperties>()
      .get<vk::PhysicalDeviceSubgroupProperties>()
      .subgroupSize;
}

DeviceLimits limitsOf(const vk::raii::PhysicalDevice& device, std::uint32_t largestStorageBuffer) {
  const auto chain = device.getProperties2<vk::PhysicalDeviceProperties2,
                                           vk::PhysicalDeviceMaintenance3Properties>();
  const vk::PhysicalDeviceLimits& limits =
      chain.get<vk::PhysicalDeviceProperties2>().properties.limits;
  return {std::min(limits.maxStorageBufferRange, largestStorageBuffer),
          limits.maxTexelBufferElements,
          chain.get<vk::PhysicalDeviceMaintenance3Properties>().maxMemoryAllocationSize,
          limits.maxComputeWorkGroupCount};
}

bool offersFloat64(const vk::raii::PhysicalDevice& device) {
  return device.getFeatures().shaderFloat64 != VK_FALSE;
}

vk::raii::Device createDevice(const vk::raii::PhysicalDevice& physical, std::uint32_t queueFamily,
                              bool float64, bool presents) {
  std::vector<const char*> extensions;
  if (presents) {
    extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
  }
  vk::PhysicalDeviceFeatures features;
  features.shaderFloat64 = float64;
  const float priority = 1;
  const vk::DeviceQueueCreateInfo queue({}, queueFamily, 1, &priority);
  try {
    return {physical, vk::DeviceCreateInfo({}, queue, {}, extensions, &features)};
  } catch (const vk::SystemError& error) {
    throw DeviceError(fmt::format("the Vulkan device {} cannot be opened: {}",
                                  physical.getProperties().deviceName.data(), error.what()));
  }
}

std::shared_ptr<const DeviceHandles> createHandles(const DeviceOptions& options,
                                                   std::vector<std::string>* messages) {
  vk::raii::Context context = loadVulkan();
  vk::raii::Instance instance = createInstance(context, options.validation, options.presentation);
  vk::raii::DebugUtilsMessengerEXT messenger =
      createMessenger(instance, options.validation, messages);
  vk::raii::PhysicalDevice physical = selectDevice(instance, options);
  const std::uint32_t queueFamily = *generalQueueFamily(physical);
  vk::raii::Device device = createDevice(physical, queueFamily, offersFloat64(physical),
                                         options.presentation.has_value());
  vk::raii::Queue queue(device, queueFamily, 0);
  const vk::PhysicalDeviceProperties properties = physical.getProperties();
  return std::make_shared<const DeviceHandles>(DeviceHandles{
      std::move(context), std::move(instance), std::move(messenger), std::move(physical),
      properties, queueFamily, std::move(device), std::move(queue)});
}

std::shared_ptr<KernelProfile> createProfile(const DeviceHandles& handles) {
  if (handles.physical.getQueueFamilyProperties()[handles.queueFamily].timestampValidBits == 0) {
    throw DeviceError(fmt::format("device {} has no timestamps: its calls cannot be timed",
                                  handles.properties.deviceName.data()));
  }
  return std::make_shared<KernelProfile>();
}

}  // namespace

std::vector<DeviceSummary> listDevices() {
  const vk::raii::Context context = loadVulkan();
  const vk::raii::Instance instance = createInstance(context, false);
  std::vector<DeviceSummary> summaries;
  for (const auto& device : physicalDevices(instance)) {
    const auto properties = device.getProperties();
    summaries.push_back({properties.deviceName.data(), typeText(properties.deviceType),
                         versionText(properties.apiVersion)});
  }
  return summaries;
}

Device::Device(const DeviceOptions& options)
    : messages_(std::make_unique<std::vector<std::string>>()),
      memoryUse_(std::make_unique<MemoryUse>()),
      handles_(createHandles(options, messages_.get())),
      name_(handles_->properties.deviceName.data()),
      limits_(limitsOf(handles_->physical, options.largestStorageBuffer)),
      hasFloat64_(offersFloat64(handles_->physical)),
      subgroupSize_(subgroupSizeOf(handles_->physical)),
      queueMutex_(std::make_unique<std::mutex>()),
      pace_(options.presentation ? std::make_shared<SubmissionPace>() : nullptr),
      programs_(std::make_shared<KernelPrograms>()),
      profile_(options.profile ? createProfile(*handles_) : nullptr) {}

std::uint32_t DeviceHandles::memoryType(std::uint32_t allowedBits,
                                        vk::MemoryPropertyFlags wanted) const {
  const auto memory = physical.getMemoryProperties();
  for (std::uint32_t n = 0; n < memory.memoryTypeCount; ++n) {
    const bool allowed = (allowedBits >> n) & 1U;
    if (allowed && (memory.memoryTypes[n].propertyFlags & wanted) == wanted) {
      return n;
    }
  }
  throw DeviceError(fmt::format("device {} has no memory of type {}", properties.deviceName.data(),
                                vk::to_string(wanted)));
}

}  // namespace morphgrid
