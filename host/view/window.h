#pragma once
#include <string>

#include "gpu/device.h"
#include "gpu/pixel_size.h"

struct GLFWwindow;

namespace morphgrid {

struct WindowOptions {
  std::string title;
  int width = 1280;
  int height = 720;
};

/// A key that went down, or that repeats while it is held.
struct KeyPress {
  int key;  ///< As GLFW numbers them.
  bool control;
  bool shift;
};

/// A window of the desktop. One at a time, used by one thread, but for wake().
class Window {
 public:
  /// Throws DeviceError that says what to do when there is no display.
  explicit Window(const WindowOptions& options);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  GLFWwindow* handle() const { return window_; }
  /// What a device needs to draw into windows.
  static Presentation presentation();
  /// For a Presenter, which owns it. Throws DeviceError when Vulkan and the window do not go
  /// together.
  VkSurfaceKHR createSurface(const Device& device) const;

  PixelSize sizeInPixels() const;
  bool isMinimised() const;
  bool shouldClose() const;
  void close();
  void setTitle(const std::string& title);

  /// Handles events; waits up to so many seconds for one where none is there. False when none came.
  bool handleEvents(double patience);
  /// Keys that have been pressed since forgetKeys(). Dear ImGui of this version misses keys that go
  /// up before its next frame.
  const std::vector<KeyPress>& keys() const { return input_.keys; }
  void forgetKeys() { input_.keys.clear(); }
  /// Ends a wait for events; from any thread.
  static void wake();

 private:
  void noteInput();

  GLFWwindow* window_ = nullptr;
  std::string title_;
  struct Input {
    std::vector<KeyPress> keys;
    bool isNew = false;  ///< Keys or the mouse, since events were last asked for.
  } input_;
};

}  // namespace morphgrid
