// SPDX-License-Identifier: MIT
// A Vulkan device with one queue, and what it can do.
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

// Seconds that work on a device may take where a command sets no limit: far longer than any pass of a picture takes on
// a software device.
inline constexpr double kTimeLimit_s = 600;

struct DeviceOptions {
  std::string device;       // index or part of a name; "" takes the best
  bool validation = false;  // core and synchronization validation; messages are collected, not printed
  // What a window needs besides (`VK_KHR_surface`, ...; `VK_KHR_swapchain`); refused by name where it is missing.
  std::vector<std::string> instance_extensions = {}, device_extensions = {};
};

// One row of the features the runtime can use (`strobe doctor` prints them).
struct Feature {
  std::string name;      // as Vulkan spells it
  std::string provides;  // what the user gets from it
  bool required = false;
  bool present = false;
};

struct DeviceInfo {
  std::string name;
  std::string driver;  // name and version
  std::string api;     // "1.4.305"
  bool software = false;
  bool measures_memory = false;  // says how much of it is free
  bool shares_memory = false;    // its memory is the machine's: a software device, or one inside of the processor
  std::vector<Feature> features;

  bool has(const std::string& feature) const;
  // The required features it lacks, as one sentence; "" when it suffices.
  std::string missing() const;
};

// Every device the loader offers, best first, with no device created. Empty without a loader or driver.
std::vector<DeviceInfo> listDevices();

// Failures to load drivers that are installed or named in the environment: messages of the loader, and manifests that
// do not exist or are damaged. A driver without its hardware is not a failure.
std::vector<std::string> driverProblems();

// The device is lost: nothing can be drawn or read back any more. Not an `Error`, so that no picture, point or frame is
// reported as failed for it: it ends the program.
struct DeviceLost : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct MessageSink;
class Commands;

// Owns instance, device and queue. Everything made from a Device must be destroyed before it.
class Device {
 public:
  // Throws `Error` when there is no device, none of that name, or it lacks a required feature (each is named with
  // what provides it).
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
  double timestampPeriodNs() const { return timestamp_period_ns_; }
  bool debugLabels() const { return vk_.CmdBeginDebugUtilsLabelEXT != nullptr; }

  // A memory type with all of `wanted` among `type_bits`, if possible with `preferred` too; throws `Error` without one.
  uint32_t memoryType(uint32_t type_bits, VkMemoryPropertyFlags wanted, VkMemoryPropertyFlags preferred) const;

  void setName(VkObjectType type, uint64_t handle, const std::string& name) const;

  // Records with `record`, submits and waits: the device is idle then. Throws `DeviceLost`. `what` names the work,
  // should it never end; `allowance_s` is added to its time limit.
  void submit(const std::function<void(VkCommandBuffer)>& record, const std::string& what = "",
              double allowance_s = 0) const;

  // Work that takes longer than `seconds` ends in `on_overrun(text)`, which must not return: a shader that never ends
  // cannot be aborted, so neither can the device be used or destroyed any more. `text` names the work. Without
  // `on_overrun` the text is printed and the program ends with exit code 1. 0 waits for ever. Default: `kTimeLimit_s`.
  using OnOverrun = std::function<void(const std::string& text)>;
  void setTimeLimit(double seconds, OnOverrun on_overrun = {});
  // The point or picture that is drawn from now on, as overruns and a lost device name it; "": it has no name.
  void setSubject(std::string subject) { subject_ = std::move(subject); }
  // How long to wait for work, ns, and what ends it.
  uint64_t limitNs(double allowance_s) const;
  [[noreturn]] void overrun(const std::string& what) const;
  // `gpu::check` with the names of the device and of its subject in `DeviceLost`.
  void check(VkResult result, const std::string& what) const;

  // Validation messages since the last call; always empty without validation.
  std::vector<std::string> takeMessages() const;
  // Throws `Error` of them, if there are any.
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
  std::unique_ptr<Commands> commands_;  // those of `submit`
  VkPhysicalDeviceMemoryProperties memory_{};
  VkPhysicalDeviceRayTracingPipelinePropertiesKHR ray_properties_{};
  uint32_t scratch_alignment_ = 256;
  double timestamp_period_ns_ = 1;
  double time_limit_s_ = kTimeLimit_s;
  OnOverrun on_overrun_;
  std::string subject_;
};

// Throws `Error` naming `what` and the result unless `result` is VK_SUCCESS; `DeviceLost` where it says so.
void check(VkResult result, const std::string& what);

// What a call gives that fills `count` items, or says in it how many there are where the list is null.
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
