// SPDX-License-Identifier: MIT
// Window of the desktop: size, events, keys, clipboard. Only `strobe live` makes one.
#pragma once

#include <string>
#include <utility>

#include "gpu/device.h"
#include "live/input_queue.h"

struct GLFWwindow;

namespace strobe::live {

// Desktop window through GLFW, with its Vulkan surface, event queue, size in pixels, title and clipboard.
class Window {
 public:
  // Throws `Error` without a display.
  Window(int width, int height, const std::string& title);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  // Instance and device extensions that a device needs to present to this window.
  gpu::DeviceOptions extensions() const;
  VkSurfaceKHR makeSurface(const gpu::Device& device) const;

  // Sends keys and buttons only to the queue from now on. Call after all other callbacks are set, because this function
  // replaces them.
  void queueInput();
  // Queues the events since the last call. With `timeout_s` > 0, waits at most that time for an event. Does not draw,
  // so the function may be called during a draw.
  void takeEvents(double timeout_s);
  // True if any event happened since the last `settle`.
  bool stirred() const { return stirred_; }
  void settle() { stirred_ = false; }
  // Waiting keys and buttons, and the batch of the last frame.
  InputQueue& input() { return input_; }
  const InputQueue& input() const { return input_; }
  bool closing() const;

  // Size of the framebuffer, pixels.
  std::pair<int, int> size() const;
  void resize(int width, int height);
  void setTitle(const std::string& title);
  void setClipboard(const std::string& text);
  GLFWwindow* handle() const { return window_; }

 private:
  static Window& of(GLFWwindow* window);
  void add(const InputEvent& event);

  GLFWwindow* window_ = nullptr;
  bool stirred_ = true;
  InputQueue input_;
};

}  // namespace strobe::live
