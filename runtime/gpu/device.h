// SPDX-License-Identifier: MIT
// A Vulkan device with one queue, its features and its error handling.
#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "gpu/dispatch.h"

namespace strobe::gpu {

// Default time limit of a submission, seconds; far longer than any pass of a picture takes on a software device.
inline constexpr double kTimeLimit_s = 600;

// Options for the creation of a Vulkan device: selection, validation, and extensions.
struct DeviceOptions {
  std::string device;       // index, part of the name, UUID or PCI address; "": `chosenDevice` (gpu/choice.h)
  bool validation = false;  // core and synchronization validation; messages are collected, not printed
  // Extensions that a window needs (`VK_KHR_surface`, ...; `VK_KHR_swapchain`). An error names a missing one.
  std::vector<std::string> instance_extensions = {}, device_extensions = {};
};

// A device feature that the runtime can use (`strobe doctor` prints them).
struct Feature {
  std::string name;      // Vulkan name
  std::string provides;  // its use in Strobe
  bool required = false;
  bool present = false;
};

// Description of a Vulkan device: name, driver, API version, memory properties and available features.
struct DeviceInfo {
  std::string name;
  std::string driver;   // name and version
  std::string api;      // "1.4.305"
  std::string uuid;     // "5a0cf3e1-..."
  std::string pci;      // address "0000:3b:00.0"; "": not a PCI device, or the driver does not report the address
  uint32_t vendor = 0;  // PCI number of the vendor
  bool software = false;
  bool measures_memory = false;  // reports its free memory
  bool shares_memory = false;    // uses the machine's memory: a software device or an integrated GPU
  std::vector<Feature> features;

  bool has(const std::string& feature) const;
  // The missing required features, as one sentence; "" if none is missing.
  std::string missing() const;
};

// Every device the loader offers, best first; creates no device. Empty without a loader or driver.
std::vector<DeviceInfo> listDevices();

// Failures to load drivers that are installed or named in the environment: messages of the loader, and manifests that
// do not exist or are damaged. A driver without its hardware is not a failure.
std::vector<std::string> driverProblems();

// The device is lost: drawing and reading back are impossible. Not an `Error`: a lost device ends the program instead
// of failing one picture, point or frame.
struct DeviceLost : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Format of the time stamps of a queue: nanoseconds per tick, and the number of valid low bits.
struct StampFormat {
  double tick_ns = 1;
  uint32_t bits = 0;  // 0: the queue has no time stamps
};

struct MessageSink;
class Commands;
class DeviceMemory;

// Owns instance, device and queue. Everything made from a Device must be destroyed before it.
class Device {
 public:
  // Throws `Error` if no device exists or matches the name, or if it lacks a required feature; the message names each
  // missing feature and its use.
  explicit Device(const DeviceOptions& options = {});
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  const DeviceInfo& info() const { return info_; }
  const Dispatch& vk() const { return vk_; }
  VkDevice handle() const { return device_; }
  VkInstance instance() const { return instance_; }
  VkPhysicalDevice physical() const { return physical_; }
  VkQueue queue() const { return queue_; }
  uint32_t queueFamily() const { return queue_family_; }
  const VkPhysicalDeviceRayTracingPipelinePropertiesKHR& rayProperties() const { return ray_properties_; }
  uint32_t scratchAlignment() const { return scratch_alignment_; }
  const StampFormat& stampFormat() const { return stamp_format_; }
  // True if time stamps measure passes. A software device executes commands only when the host waits, so its time
  // stamps are not usable.
  bool measuresTimes() const { return stamp_format_.bits > 0 && !info_.software; }
  bool debugLabels() const { return vk_.CmdBeginDebugUtilsLabelEXT != nullptr; }

  DeviceMemory& memory() const { return *memory_; }

  void setName(VkObjectType type, uint64_t handle, const std::string& name) const;

  // Records with `record`, submits and waits; the device is then idle. Throws `DeviceLost`. `what` names the work if
  // the time limit is exceeded; `allowance_s` is added to the time limit.
  void submit(const std::function<void(VkCommandBuffer)>& record, const std::string& what = "",
              double allowance_s = 0) const;

  // Time limit of a submission, seconds; 0: unlimited; default `kTimeLimit_s`. After the limit, `on_overrun(text)` is
  // called; `text` names the work. It must not return: a running shader cannot be aborted, so the device can be neither
  // used nor destroyed. Without `on_overrun`, the text is printed and the program ends with exit code 1.
  using OnOverrun = std::function<void(const std::string& text)>;
  void setTimeLimit(double seconds, OnOverrun on_overrun = {});
  // Name of the current point or picture, for messages about overruns and a lost device; "": none.
  void setSubject(std::string subject) { subject_ = std::move(subject); }
  // Time limit of a submission, ns, and the handler for exceeding it.
  uint64_t limitNs(double allowance_s) const;
  [[noreturn]] void overrun(const std::string& what) const;
  // Like `gpu::check`; a `DeviceLost` also names the device and the current subject.
  void check(VkResult result, const std::string& what) const;

  // Validation messages since the last call; always empty without validation.
  std::vector<std::string> takeMessages() const;
  // Throws `Error` with the validation messages, if any.
  void refuseMessages() const;

 private:
  void createInstance(const DeviceOptions& options);
  void choosePhysicalDevice(const std::string& wanted);
  void createDevice(const std::vector<std::string>& more_extensions);
  void destroy();

  std::unique_ptr<MessageSink> messages_;
  void* library_ = nullptr;
  Dispatch vk_;
  DeviceInfo info_;
  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  VkPhysicalDevice physical_ = VK_NULL_HANDLE;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  uint32_t queue_family_ = 0;
  std::unique_ptr<DeviceMemory> memory_;
  std::unique_ptr<Commands> commands_;  // for `submit`
  VkPhysicalDeviceRayTracingPipelinePropertiesKHR ray_properties_{};
  uint32_t scratch_alignment_ = 256;
  StampFormat stamp_format_;
  double time_limit_s_ = kTimeLimit_s;
  OnOverrun on_overrun_;
  std::string subject_;
};

// Throws `Error` with `what` and the result unless `result` is VK_SUCCESS; throws `DeviceLost` for
// VK_ERROR_DEVICE_LOST.
void check(VkResult result, const std::string& what);

// Returns the items of a Vulkan enumeration: `call(count, list)` sets `count` if `list` is null, otherwise fills
// `list`.
template <class Item, class Call>
std::vector<Item> listed(const Call& call) {
  uint32_t count = 0;
  call(&count, static_cast<Item*>(nullptr));
  std::vector<Item> items(count);
  call(&count, items.data());
  items.resize(count);
  return items;
}

}  // namespace strobe::gpu
