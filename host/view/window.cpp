#include "view/window.h"

#define GLFW_INCLUDE_NONE
#define GLFW_INCLUDE_VULKAN
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <chrono>

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
  glfwSetWindowUserPointer(window_, &input_);
  noteInput();
}

void Window::noteInput() {
  static constexpr auto kInputOf = [](GLFWwindow* window) -> Input& {
    Input& input = *static_cast<Input*>(glfwGetWindowUserPointer(window));
    input.isNew = true;
    return input;
  };
  glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int, int action, int mods) {
    Input& input = kInputOf(window);
    if (action != GLFW_RELEASE) {
      input.keys.push_back({key, (mods & GLFW_MOD_CONTROL) != 0, (mods & GLFW_MOD_SHIFT) != 0});
    }
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int, int, int) { kInputOf(window); });
  glfwSetCursorPosCallback(window_, [](GLFWwindow* window, double, double) { kInputOf(window); });
  glfwSetScrollCallback(window_, [](GLFWwindow* window, double, double) { kInputOf(window); });
}

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

Presentation Window::presentation() {
  std::uint32_t count = 0;
  const char** names = glfwGetRequiredInstanceExtensions(&count);
  if (!names) {
    // The display is there, a window has been opened on it: it is Vulkan that is not.
    listDevices();  // Says what is missing where there is no device at all.
    throw DeviceError(fmt::format(
        "no Vulkan driver here can draw into a window ({}); install one for your GPU, or the "
        "software device: apt-get install mesa-vulkan-drivers; `morphgrid run` needs no window",
        lastComplaint()));
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

bool Window::handleEvents(double patience) {
  using Clock = std::chrono::steady_clock;
  input_.isNew = false;
  const auto begin = Clock::now();
  if (patience > 0) {
    glfwWaitEventsTimeout(patience);
  } else {
    glfwPollEvents();
  }
  // GLFW does not tell whether a wait has ended with an event; one may come with its very end.
  return input_.isNew || std::chrono::duration<double>(Clock::now() - begin).count() < patience;
}

void Window::wake() { glfwPostEmptyEvent(); }

}  // namespace morphgrid
