// SPDX-License-Identifier: MIT
// The window of the desktop: its size, its events, keys, the clipboard. Only `strobe live` makes one.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "gpu/device.h"

struct GLFWwindow;

namespace strobe::live {

class Window {
 public:
  // Throws `Error` where there is no display.
  Window(int width, int height, const std::string& title);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  // Instance and device extensions that a device must have to show pictures here.
  gpu::DeviceOptions extensions() const;
  VkSurfaceKHR makeSurface(const gpu::Device& device) const;

  // Takes what happened since the last call; with `timeout_s` > 0, waits for something to happen, so long at most.
  void takeEvents(double timeout_s);
  // Whether anything happened in the last `takeEvents`.
  bool stirred() const { return stirred_; }
  // Keys pressed in the last `takeEvents`, as keys.h counts them.
  const std::vector<int>& pressed() const { return pressed_; }
  bool isDown(int key) const;  // by GLFW's code
  bool closing() const;

  // In pixels.
  std::pair<int, int> size() const;
  void resize(int width, int height);
  void setTitle(const std::string& title);
  void setClipboard(const std::string& text);
  GLFWwindow* handle() const { return window_; }

 private:
  static Window& of(GLFWwindow* window);

  GLFWwindow* window_ = nullptr;
  bool stirred_ = true;
  std::vector<int> pressed_;
};

}  // namespace strobe::live
