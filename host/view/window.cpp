#include "view/window.h"

#define GLFW_INCLUDE_NONE
#define GLFW_INCLUDE_VULKAN
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include "core/error.h"
#include "gpu/vulkan_device.h"

namespace morphgrid {
namespace {

std::string lastComplaint() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "no reason given";
}

[[noreturn]] void failToOpen(const std::string& reason) {
  throw DeviceError(fmt::format(
      "no window can be opened ({}); start this on a desktop or set DISPLAY, or use `morphgrid "
      "run`, which needs none",
      reason));
}

}  // namespace

Window::Window(const WindowOptions& options) : title_(options.title) {
  if (glfwInit() != GLFW_TRUE) {
    failToOpen(lastComplaint());
  }
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  window_ = glfwCreateWindow(options.width, options.height, title_.c_str(), nullptr, nullptr);
  if (!window_) {
    const std::string reason = lastComplaint();
    glfwTerminate();
    failToOpen(reason);
  }
  glfwSetWindowUserPointer(window_, &keys_);
  glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int, int action, int mods) {
    if (action != GLFW_RELEASE) {
      static_cast<std::vector<KeyPress>*>(glfwGetWindowUserPointer(window))
          ->push_back({key, (mods & GLFW_MOD_CONTROL) != 0, (mods & GLFW_MOD_SHIFT) != 0});
    }
  });
}

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

Presentation Window::presentation() {
  std::uint32_t count = 0;
  const char** names = glfwGetRequiredInstanceExtensions(&count);
  if (!names) {
    failToOpen(lastComplaint());
  }
  return {{names, names + count},
          [](VkInstance instance, VkPhysicalDevice device, std::uint32_t queueFamily) {
            return glfwGetPhysicalDevicePresentationSupport(instance, device, queueFamily) ==
                   GLFW_TRUE;
          }};
}

VkSurfaceKHR Window::createSurface(const Device& device) const {
  VkSurfaceKHR surface = VK_NULL_HANDLE;
  if (glfwCreateWindowSurface(*device.handles().instance, window_, nullptr, &surface) !=
      VK_SUCCESS) {
    failToOpen(lastComplaint());
  }
  return surface;
}

PixelSize Window::sizeInPixels() const {
  int width = 0;
  int height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  return {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
}

bool Window::isMinimised() const {
  const PixelSize size = sizeInPixels();
  return size.width == 0 || size.height == 0 ||
         glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE;
}

bool Window::shouldClose() const { return glfwWindowShouldClose(window_) == GLFW_TRUE; }

void Window::close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }

void Window::setTitle(const std::string& title) {
  if (title != title_) {
    title_ = title;
    glfwSetWindowTitle(window_, title.c_str());
  }
}

void Window::handleEvents(double patience) {
  keys_.clear();
  if (patience > 0) {
    glfwWaitEventsTimeout(patience);
  } else {
    glfwPollEvents();
  }
}

void Window::wake() { glfwPostEmptyEvent(); }

}  // namespace morphgrid
