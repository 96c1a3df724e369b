// SPDX-License-Identifier: MIT
// The window of the desktop: its size, its events, keys, the clipboard. Only `strobe live` makes one.
#pragma once

#include <string>
#include <utility>

#include "gpu/device.h"
#include "live/input_queue.h"

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

  // From here on keys and buttons go to the queue alone: the last callbacks that are set.
  void queueInput();
  // Queues what happened since the last call; with `timeout_s` > 0, waits for something to happen, so long at most.
  // Draws nothing, so it may be called while something else is drawn.
  void takeEvents(double timeout_s);
  // True if anything happened since the last `settle`.
  bool stirred() const { return stirred_; }
  void settle() { stirred_ = false; }
  // Keys and buttons that wait, and the batch of the last frame.
  InputQueue& input() { return input_; }
  const InputQueue& input() const { return input_; }
  bool closing() const;

  // In pixels.
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
