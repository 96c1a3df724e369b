// SPDX-License-Identifier: MIT
#include "gpu/device.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <mutex>
#include <sstream>
#include <utility>

#include "base/cores.h"
#include "base/files.h"
#include "base/json.h"
#include "gpu/choice.h"
#include "gpu/commands.h"
#include "gpu/features.h"
#include "gpu/memory.h"
#include "gpu/renderdoc.h"

namespace strobe::gpu {

struct MessageSink {
  std::mutex mutex;
  std::vector<std::string> texts;
};

void check(VkResult result, const std::string& what) {
  static const std::map<VkResult, std::string> names = {{VK_ERROR_OUT_OF_HOST_MEMORY, "out of host memory"},
                                                        {VK_ERROR_OUT_OF_DEVICE_MEMORY, "out of device memory"},
                                                        {VK_ERROR_INITIALIZATION_FAILED, "initialization failed"},
                                                        {VK_ERROR_DEVICE_LOST, "the device was lost"},
                                                        {VK_ERROR_LAYER_NOT_PRESENT, "a layer is not present"},
                                                        {VK_ERROR_EXTENSION_NOT_PRESENT, "an extension is not present"},
                                                        {VK_ERROR_FEATURE_NOT_PRESENT, "a feature is not present"},
                                                        {VK_ERROR_INCOMPATIBLE_DRIVER, "no compatible driver"},
                                                        {VK_ERROR_FORMAT_NOT_SUPPORTED, "the format is not supported"},
                                                        {VK_ERROR_MEMORY_MAP_FAILED, "the memory cannot be mapped"},
                                                        {VK_ERROR_TOO_MANY_OBJECTS, "too many objects of this kind"},
                                                        {VK_ERROR_OUT_OF_POOL_MEMORY, "out of pool memory"},
                                                        {VK_ERROR_FRAGMENTED_POOL, "the pool is fragmented"},
                                                        {VK_ERROR_FRAGMENTATION, "out of address space"},
                                                        {VK_ERROR_SURFACE_LOST_KHR, "the window was lost"},
                                                        {VK_ERROR_UNKNOWN, "an unknown error of the driver"},
                                                        {VK_TIMEOUT, "timed out"}};
  if (result == VK_SUCCESS) return;
  auto name = names.find(result);
  std::string text =
      fmt::format("Vulkan: {}: {}", what, name == names.end() ? fmt::format("result {}", int(result)) : name->second);
  if (result == VK_ERROR_DEVICE_LOST) throw DeviceLost(text);
  throw Error(text);
}

// The loader is opened at run time: a machine without Vulkan gets an error message, not a link failure.
static PFN_vkGetInstanceProcAddr openLoader(void** library) {
  *library = ::dlopen("libvulkan.so.1", RTLD_NOW | RTLD_LOCAL);
  if (!*library) return nullptr;
  return reinterpret_cast<PFN_vkGetInstanceProcAddr>(::dlsym(*library, "vkGetInstanceProcAddr"));
}

static const char* kNoDevice =
    "no Vulkan device: install a driver (Debian: mesa-vulkan-drivers gives a software device) or check VK_DRIVER_FILES";

static const char* kHiddenByRenderDoc =
    "; RenderDoc hides these features if a device lacks bufferDeviceAddressCaptureReplay, as software devices do";

static VKAPI_ATTR VkBool32 VKAPI_CALL onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                                const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
  std::string text = data->pMessage ? data->pMessage : "";
  // All images stay in the GENERAL layout by design; this is a performance hint about it.
  bool general_layout_hint = text.find("VK_IMAGE_LAYOUT_GENERAL") != std::string::npos &&
                             text.find("UNASSIGNED-CoreValidation-DrawState-InvalidImageLayout") == std::string::npos &&
                             text.find("VUID") == std::string::npos;
  if (general_layout_hint) return VK_FALSE;
  auto* sink = static_cast<MessageSink*>(user);
  std::lock_guard lock(sink->mutex);
  sink->texts.push_back(text);
  return VK_FALSE;
}

Device::Device(const DeviceOptions& options) : messages_(std::make_unique<MessageSink>()) {
  try {
    createInstance(options);
    choosePhysicalDevice(options.device);
    createDevice(options.device_extensions);
    memory_ = std::make_unique<DeviceMemory>(*this);
    commands_ = std::make_unique<Commands>(*this, "commands");
  } catch (...) {
    destroy();
    throw;
  }
}

Device::~Device() { destroy(); }

void Device::destroy() {
  if (device_) {
    vk_.DeviceWaitIdle(device_);
    commands_.reset();
    memory_.reset();
    vk_.DestroyDevice(device_, nullptr);
  }
  if (messenger_) vk_.DestroyDebugUtilsMessengerEXT(instance_, messenger_, nullptr);
  if (instance_) vk_.DestroyInstance(instance_, nullptr);
}

namespace {

// Reason why the loader cannot read a manifest; "" if it can.
std::string faultOfManifest(const std::string& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return "";  // absent, or a folder of manifests
  try {
    const Json json = Json::parse(readText(file), nullptr, false);
    if (json.is_discarded()) return "is not valid JSON";
    const Json::json_pointer library("/ICD/library_path");
    return json.contains(library) && json[library].is_string() ? "" : "has no ICD.library_path";
  } catch (const Error& error) {
    return error.message();
  }
}

// Faults of the manifests named in the environment. `absent`: of missing files, which the loader skips silently;
// otherwise of damaged files. With a damaged manifest the loader finds no driver, or crashes.
std::vector<std::string> faultyManifests(bool absent) {
  std::vector<std::string> faults;
  const char* variables[] = {std::getenv("VK_DRIVER_FILES") ? "VK_DRIVER_FILES" : "VK_ICD_FILENAMES",
                             "VK_ADD_DRIVER_FILES"};
  std::error_code ignored;
  for (const char* variable : variables) {
    std::istringstream names(std::getenv(variable) ? std::getenv(variable) : "");
    for (std::string name; std::getline(names, name, ':');) {
      if (name.empty()) continue;
      const bool is_there = std::filesystem::exists(name, ignored);
      const std::string fault = !absent ? faultOfManifest(name) : is_there ? "" : "no such file";
      if (!fault.empty()) faults.push_back(fmt::format("{}: {}: {}", variable, name, fault));
    }
  }
  return faults;
}

// Sets the number of threads of a software device, unless the user has set it. The driver itself counts the processors
// of the machine and ignores quotas.
void limitSoftwareDevice() {
  if (allowedCores() < machineCores()) ::setenv("LP_NUM_THREADS", std::to_string(allowedCores()).c_str(), 0);
}

struct VulkanLoader {
  void* library = nullptr;
  PFN_vkGetInstanceProcAddr get = nullptr;
  std::vector<std::string> extensions;

  VulkanLoader() {
    const std::vector<std::string> damaged = faultyManifests(false);
    if (!damaged.empty()) throw Error(fmt::format("{}", fmt::join(damaged, "; ")));
    get = openLoader(&library);
    if (!get) throw Error(kNoDevice);
    auto list_extensions = reinterpret_cast<PFN_vkEnumerateInstanceExtensionProperties>(
        get(nullptr, "vkEnumerateInstanceExtensionProperties"));
    auto of_loader = [&](uint32_t* count, VkExtensionProperties* list) { list_extensions(nullptr, count, list); };
    for (const auto& extension : listed<VkExtensionProperties>(of_loader))
      extensions.push_back(extension.extensionName);
  }

  static bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  }

  // Messages of the loader itself go to `messages`, if the loader has the extension for it.
  VkInstance create(bool validation, const std::vector<std::string>& more_extensions = {},
                    const VkDebugUtilsMessengerCreateInfoEXT* messages = nullptr) const {
    VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
    application.pApplicationName = "strobe";
    application.apiVersion = VK_API_VERSION_1_3;
    std::vector<const char*> used_layers, used_extensions;
    if (validation) used_layers.push_back("VK_LAYER_KHRONOS_validation");
    bool has_messages = contains(extensions, VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    if (has_messages || validation) used_extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    for (const std::string& name : more_extensions) {
      if (!contains(extensions, name))
        throw Error(fmt::format("no Vulkan driver here has {}, which a window needs", name));
      used_extensions.push_back(name.c_str());
    }
    VkValidationFeatureEnableEXT synchronization = VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
    VkValidationFeaturesEXT features{VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT};
    features.enabledValidationFeatureCount = 1;
    features.pEnabledValidationFeatures = &synchronization;
    VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    if (validation) info.pNext = &features;
    else if (has_messages) info.pNext = messages;
    info.pApplicationInfo = &application;
    info.enabledLayerCount = uint32_t(used_layers.size());
    info.ppEnabledLayerNames = used_layers.data();
    info.enabledExtensionCount = uint32_t(used_extensions.size());
    info.ppEnabledExtensionNames = used_extensions.data();
    limitSoftwareDevice();
    auto create_instance = reinterpret_cast<PFN_vkCreateInstance>(get(nullptr, "vkCreateInstance"));
    VkInstance instance = VK_NULL_HANDLE;
    VkResult result = create_instance(&info, nullptr, &instance);
    if (result == VK_ERROR_LAYER_NOT_PRESENT)
      throw Error("Vulkan's validation layer is not installed (Debian: vulkan-validationlayers)");
    if (result == VK_ERROR_INCOMPATIBLE_DRIVER) throw Error(kNoDevice);
    check(result, "creating the instance");
    return instance;
  }
};

void loadInstanceCalls(Dispatch& vk, PFN_vkGetInstanceProcAddr get, VkInstance instance) {
#define X(name) vk.name = reinterpret_cast<PFN_vk##name>(get(instance, "vk" #name));
  STROBE_INSTANCE_CALLS(X)
  STROBE_OPTIONAL_INSTANCE_CALLS(X)
#undef X
}

void loadDeviceCalls(Dispatch& vk, VkDevice device) {
#define X(name) vk.name = reinterpret_cast<PFN_vk##name>(vk.GetDeviceProcAddr(device, "vk" #name));
  STROBE_DEVICE_CALLS(X)
  STROBE_RAY_CALLS(X)
  STROBE_WINDOW_CALLS(X)
#undef X
}

std::vector<VkPhysicalDevice> physicalDevices(const Dispatch& vk, VkInstance instance) {
  return listed<VkPhysicalDevice>(
      [&](uint32_t* count, VkPhysicalDevice* list) { vk.EnumeratePhysicalDevices(instance, count, list); });
}

std::vector<std::string> deviceExtensions(const Dispatch& vk, VkPhysicalDevice device) {
  auto of_device = [&](uint32_t* count, VkExtensionProperties* list) {
    vk.EnumerateDeviceExtensionProperties(device, nullptr, count, list);
  };
  std::vector<std::string> names;
  for (const auto& extension : listed<VkExtensionProperties>(of_device)) names.push_back(extension.extensionName);
  return names;
}

// PCI address; "" without VK_EXT_pci_bus_info.
std::string pciAddress(const Dispatch& vk, VkPhysicalDevice device, const std::vector<std::string>& extensions) {
  if (!VulkanLoader::contains(extensions, VK_EXT_PCI_BUS_INFO_EXTENSION_NAME)) return "";
  VkPhysicalDevicePCIBusInfoPropertiesEXT pci{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PCI_BUS_INFO_PROPERTIES_EXT};
  VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &pci};
  vk.GetPhysicalDeviceProperties2(device, &properties);
  return pciText(pci.pciDomain, pci.pciBus, pci.pciDevice, pci.pciFunction);
}

DeviceInfo describe(const Dispatch& vk, VkPhysicalDevice device) {
  VkPhysicalDeviceIDProperties id{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ID_PROPERTIES};
  VkPhysicalDeviceDriverProperties driver{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES, &id};
  VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &driver};
  vk.GetPhysicalDeviceProperties2(device, &properties);
  DeviceInfo info;
  const VkPhysicalDeviceProperties& core = properties.properties;
  info.name = core.deviceName;
  info.driver = fmt::format("{} {}", driver.driverName, driver.driverInfo);
  info.uuid = uuidText(id.deviceUUID), info.vendor = core.vendorID;
  info.api = fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(core.apiVersion), VK_API_VERSION_MINOR(core.apiVersion),
                         VK_API_VERSION_PATCH(core.apiVersion));
  info.software = core.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
  info.shares_memory = info.software || core.deviceType == VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU;

  // A device older than Vulkan 1.3 lacks the structures below: all features count as absent.
  std::vector<std::string> extensions = deviceExtensions(vk, device);
  info.pci = pciAddress(vk, device, extensions);
  info.measures_memory = VulkanLoader::contains(extensions, VK_EXT_MEMORY_BUDGET_EXTENSION_NAME);
  FeatureChain chain;
  if (core.apiVersion >= VK_API_VERSION_1_3) vk.GetPhysicalDeviceFeatures2(device, chain.chain(extensions));
  for (const WantedFeature& wanted : wantedFeatures())
    info.features.push_back({wanted.name, wanted.provides, wanted.required, wanted.in(chain) == VK_TRUE});
  return info;
}

// Order: usable GPUs, usable software devices, other devices.
int rank(const DeviceInfo& info) {
  int suffices = info.missing().empty() ? 0 : 4;
  return suffices + (info.software ? 2 : 0);
}

}  // namespace

bool DeviceInfo::has(const std::string& feature) const {
  return std::any_of(features.begin(), features.end(),
                     [&](const Feature& one) { return one.name == feature && one.present; });
}

std::string DeviceInfo::missing() const {
  std::vector<std::string> names;
  for (const Feature& feature : features)
    if (feature.required && !feature.present) names.push_back(fmt::format("{} ({})", feature.name, feature.provides));
  return fmt::format("{}", fmt::join(names, ", "));
}

std::vector<DeviceInfo> listDevices() {
  std::vector<DeviceInfo> infos;
  try {
    VulkanLoader loader;
    VkInstance instance = loader.create(false);
    Dispatch vk;
    loadInstanceCalls(vk, loader.get, instance);
    for (VkPhysicalDevice device : physicalDevices(vk, instance)) infos.push_back(describe(vk, device));
    vk.DestroyInstance(instance, nullptr);
  } catch (const Error&) {
    return {};
  }
  std::stable_sort(infos.begin(), infos.end(),
                   [](const DeviceInfo& a, const DeviceInfo& b) { return rank(a) < rank(b); });
  return infos;
}

static VKAPI_ATTR VkBool32 VKAPI_CALL onLoaderMessage(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                                      VkDebugUtilsMessageTypeFlagsEXT,
                                                      const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
  std::string text = data->pMessage ? data->pMessage : "";
  // Warnings may be about layers; only a warning that names an ICD is kept.
  bool is_error = severity >= VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  if (is_error || text.find("ICD") != std::string::npos)
    static_cast<std::vector<std::string>*>(user)->push_back(std::move(text));
  return VK_FALSE;
}

std::vector<std::string> driverProblems() {
  std::vector<std::string> problems = faultyManifests(true), messages;
  VkDebugUtilsMessengerCreateInfoEXT sink{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
  sink.messageSeverity =
      VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  sink.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_GENERAL_BIT_EXT;
  sink.pfnUserCallback = onLoaderMessage;
  sink.pUserData = &messages;
  try {
    VulkanLoader loader;
    VkInstance instance = loader.create(false, {}, &sink);
    Dispatch vk;
    loadInstanceCalls(vk, loader.get, instance);
    physicalDevices(vk, instance);
    vk.DestroyInstance(instance, nullptr);
  } catch (const Error& error) {
    if (messages.empty()) messages.push_back(error.what());
  }
  for (std::string& message : messages)
    if (std::find(problems.begin(), problems.end(), message) == problems.end()) problems.push_back(std::move(message));
  return problems;
}

void Device::createInstance(const DeviceOptions& options) {
  VulkanLoader loader;
  library_ = loader.library;
  instance_ = loader.create(options.validation, options.instance_extensions);
  loadInstanceCalls(vk_, loader.get, instance_);
  if (!options.validation) return;
  VkDebugUtilsMessengerCreateInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
  info.messageSeverity =
      VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
  info.pfnUserCallback = onMessage;
  info.pUserData = messages_.get();
  check(vk_.CreateDebugUtilsMessengerEXT(instance_, &info, nullptr, &messenger_), "creating the messenger");
}

void Device::choosePhysicalDevice(const std::string& wanted) {
  std::vector<std::pair<DeviceInfo, VkPhysicalDevice>> found;
  for (VkPhysicalDevice device : physicalDevices(vk_, instance_)) found.push_back({describe(vk_, device), device});
  if (found.empty()) throw Error(kNoDevice);
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return rank(a.first) < rank(b.first); });

  std::vector<DeviceInfo> infos;
  for (const auto& [info, device] : found) infos.push_back(info);
  const size_t chosen = chosenDevice(infos, wanted, gpusOfJob());
  info_ = found[chosen].first;
  physical_ = found[chosen].second;
  std::string missing = info_.missing();
  if (!missing.empty())
    throw Error(fmt::format("device '{}' ({}) lacks {}{}", info_.name, info_.driver, missing,
                            RenderDoc::isLoaded() ? kHiddenByRenderDoc : ""));
}

void Device::createDevice(const std::vector<std::string>& more_extensions) {
  auto families = listed<VkQueueFamilyProperties>([&](uint32_t* count, VkQueueFamilyProperties* list) {
    vk_.GetPhysicalDeviceQueueFamilyProperties(physical_, count, list);
  });
  auto draws_and_computes = [](const VkQueueFamilyProperties& family) {
    return family.queueFlags & VK_QUEUE_GRAPHICS_BIT && family.queueFlags & VK_QUEUE_COMPUTE_BIT;
  };
  auto family = std::find_if(families.begin(), families.end(), draws_and_computes);
  queue_family_ = uint32_t(family - families.begin());
  if (family == families.end()) throw Error(fmt::format("device '{}' has no graphics and compute queue", info_.name));
  stamp_format_.bits = family->timestampValidBits;

  // Query the available extensions, then enable only the listed ones.
  std::vector<std::string> available = deviceExtensions(vk_, physical_);
  std::vector<const char*> extensions = wantedExtensions(available);
  std::vector<std::string> enabled(extensions.begin(), extensions.end());
  for (const std::string& name : more_extensions) {
    if (std::find(available.begin(), available.end(), name) == available.end())
      throw Error(fmt::format("device '{}' has no {}, which a window needs", info_.name, name));
    extensions.push_back(name.c_str());
  }
  FeatureChain present, use;
  vk_.GetPhysicalDeviceFeatures2(physical_, present.chain(enabled));
  VkPhysicalDeviceFeatures2* features = use.chain(enabled);
  for (const WantedFeature& feature : wantedFeatures()) feature.in(use) = feature.in(present);

  float priority = 1;
  VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
  queue.queueFamilyIndex = queue_family_;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, features};
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.enabledExtensionCount = uint32_t(extensions.size());
  info.ppEnabledExtensionNames = extensions.data();
  check(vk_.CreateDevice(physical_, &info, nullptr, &device_), fmt::format("creating device '{}'", info_.name));
  loadDeviceCalls(vk_, device_);
  vk_.GetDeviceQueue(device_, queue_family_, 0, &queue_);

  VkPhysicalDeviceAccelerationStructurePropertiesKHR acceleration{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_PROPERTIES_KHR};
  ray_properties_ = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_TRACING_PIPELINE_PROPERTIES_KHR};
  if (info_.has("rayTracingPipeline")) acceleration.pNext = &ray_properties_;
  VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2,
                                         info_.has("accelerationStructure") ? &acceleration : nullptr};
  vk_.GetPhysicalDeviceProperties2(physical_, &properties);
  scratch_alignment_ = std::max(1u, acceleration.minAccelerationStructureScratchOffsetAlignment);
  stamp_format_.tick_ns = properties.properties.limits.timestampPeriod;
}

void Device::setName(VkObjectType type, uint64_t handle, const std::string& name) const {
  if (!vk_.SetDebugUtilsObjectNameEXT) return;
  VkDebugUtilsObjectNameInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT};
  info.objectType = type;
  info.objectHandle = handle;
  info.pObjectName = name.c_str();
  vk_.SetDebugUtilsObjectNameEXT(device_, &info);
}

void Device::setTimeLimit(double seconds, OnOverrun on_overrun) {
  time_limit_s_ = seconds;
  on_overrun_ = std::move(on_overrun);
}

uint64_t Device::limitNs(double allowance_s) const {
  return time_limit_s_ > 0 ? uint64_t((time_limit_s_ + allowance_s) * 1e9) : UINT64_MAX;
}

void Device::overrun(const std::string& what) const {
  std::string text = fmt::format("{}{} ran for more than {:g} s on the device", subject_.empty() ? "" : subject_ + ": ",
                                 what.empty() ? "unnamed work" : "'" + what + "'", time_limit_s_);
  if (on_overrun_) on_overrun_(text);
  // Destroy nothing: destruction would wait for the device.
  std::fprintf(stderr, "strobe: %s\n", text.c_str());
  std::fflush(stderr);
  std::_Exit(1);
}

void Device::check(VkResult result, const std::string& what) const {
  if (result == VK_ERROR_DEVICE_LOST)
    throw DeviceLost(fmt::format("{}the device '{}' was lost ({}): its driver failed or was reset",
                                 subject_.empty() ? "" : subject_ + ": ", info_.name, what));
  gpu::check(result, what);
}

void Device::submit(const std::function<void(VkCommandBuffer)>& record, const std::string& what,
                    double allowance_s) const {
  commands_->submit(record);
  commands_->wait(what, allowance_s);
}

std::vector<std::string> Device::takeMessages() const {
  std::lock_guard lock(messages_->mutex);
  return std::exchange(messages_->texts, {});
}

void Device::refuseMessages() const {
  std::vector<std::string> messages = takeMessages();
  for (std::string& message : messages) message = "Vulkan validation: " + message;
  throwIfAny(messages);
}

}  // namespace strobe::gpu
