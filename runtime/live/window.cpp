// SPDX-License-Identifier: MIT
#include "live/window.h"

#define GLFW_INCLUDE_NONE
// GLFW declares its Vulkan functions only if the Vulkan header comes first.
#include <GLFW/glfw3.h>

namespace strobe::live {

static std::string lastError() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "no reason given";
}

Window& Window::of(GLFWwindow* window) { return *static_cast<Window*>(glfwGetWindowUserPointer(window)); }

Window::Window(int width, int height, const std::string& title) {
  if (!glfwInit())
    throw Error(
        fmt::format("no window can be opened here ({}); 'strobe render' needs none, and 'xvfb-run strobe live' "
                    "provides its own display",
                    lastError()));
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (!window_) {
    std::string reason = lastError();
    glfwTerminate();
    throw Error(fmt::format("a window of {}x{} cannot be opened: {}", width, height, reason));
  }
  glfwSetWindowUserPointer(window_, this);
  // ImGui's callbacks are set later and call these.
  glfwSetCursorPosCallback(window_, [](GLFWwindow* window, double, double) { of(window).stirred_ = true; });
  glfwSetCursorEnterCallback(window_, [](GLFWwindow* window, int) { of(window).stirred_ = true; });
  glfwSetScrollCallback(window_, [](GLFWwindow* window, double, double) { of(window).stirred_ = true; });
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* window, int, int) { of(window).stirred_ = true; });
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* window) { of(window).stirred_ = true; });
  glfwSetWindowFocusCallback(window_, [](GLFWwindow* window, int) { of(window).stirred_ = true; });
}

void Window::queueInput() {
  glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int scancode, int action, int mods) {
    of(window).add({InputEvent::Kind::Key, key, scancode, action, mods});
  });
  glfwSetCharCallback(window_, [](GLFWwindow* window, unsigned character) {
    of(window).add({InputEvent::Kind::Text, int(character)});
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int button, int action, int mods) {
    dvec2 at(0);
    glfwGetCursorPos(window, &at.x, &at.y);
    of(window).add({InputEvent::Kind::Button, button, 0, action, mods, at});
  });
}

void Window::add(const InputEvent& event) {
  stirred_ = true;
  input_.add(event);
}

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

gpu::DeviceOptions Window::extensions() const {
  uint32_t count = 0;
  const char** names = glfwGetRequiredInstanceExtensions(&count);
  if (!names) throw Error(fmt::format("this display cannot show Vulkan images: {}", lastError()));
  gpu::DeviceOptions options;
  options.instance_extensions.assign(names, names + count);
  options.device_extensions = {VK_KHR_SWAPCHAIN_EXTENSION_NAME};
  return options;
}

VkSurfaceKHR Window::makeSurface(const gpu::Device& device) const {
  VkSurfaceKHR surface = VK_NULL_HANDLE;
  gpu::check(glfwCreateWindowSurface(device.instance(), window_, nullptr, &surface), "making the window's surface");
  return surface;
}

void Window::takeEvents(double timeout_s) {
  if (timeout_s > 0 && !stirred_) glfwWaitEventsTimeout(timeout_s);
  else glfwPollEvents();
}

bool Window::closing() const { return glfwWindowShouldClose(window_); }

std::pair<int, int> Window::size() const {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  return {width, height};
}

void Window::resize(int width, int height) { glfwSetWindowSize(window_, width, height); }
void Window::setTitle(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }
void Window::setClipboard(const std::string& text) { glfwSetClipboardString(window_, text.c_str()); }

}  // namespace strobe::live
