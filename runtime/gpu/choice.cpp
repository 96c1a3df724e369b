// SPDX-License-Identifier: MIT
#include "gpu/choice.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <regex>

namespace strobe::gpu {

namespace {

constexpr uint32_t kNvidia = 0x10de;  // CUDA_VISIBLE_DEVICES counts the GPUs of this vendor only

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

bool isNumber(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c); });
}

// PCI address in the form of `pciText`, from a form with or without domain and function ("3B:00", "00000000:3B:00.0");
// "" for another text.
std::string pciIn(const std::string& text) {
  static const std::regex form("(?:([0-9a-f]{4,8}):)?([0-9a-f]{1,2}):([0-9a-f]{1,2})(?:\\.([0-7]))?");
  std::smatch parts;
  const std::string address = lower(text);
  if (!std::regex_match(address, parts, form)) return "";
  auto number = [&](size_t i) { return parts[i].matched ? uint32_t(std::stoul(parts[i], nullptr, 16)) : 0; };
  return pciText(number(1), number(2), number(3), number(4));
}

// UUID in lower case without the prefix "GPU-"; "" for another text. With the prefix, the UUID may be cut short, as in
// CUDA_VISIBLE_DEVICES.
std::string uuidIn(const std::string& text) {
  static const std::regex whole("[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}"), part("gpu-[0-9a-f][-0-9a-f]*");
  const std::string uuid = lower(text);
  if (std::regex_match(uuid, part)) return uuid.substr(4);
  return std::regex_match(uuid, whole) ? uuid : "";
}

bool matches(const DeviceInfo& device, const std::string& wanted) {
  if (const std::string pci = pciIn(wanted); !pci.empty()) return device.pci == pci;
  if (const std::string uuid = uuidIn(wanted); !uuid.empty()) return device.uuid.starts_with(uuid);
  return lower(device.name).find(lower(wanted)) != std::string::npos;
}

// Indices of the GPUs that CUDA counts, by PCI address. A GPU with two drivers counts once.
std::vector<size_t> gpusInPciOrder(const std::vector<DeviceInfo>& devices) {
  std::vector<size_t> gpus;
  for (size_t i = 0; i < devices.size(); ++i)
    if (devices[i].vendor == kNvidia && !devices[i].software) gpus.push_back(i);
  auto pci = [&](size_t i) { return devices[i].pci; };
  std::stable_sort(gpus.begin(), gpus.end(), [&](size_t a, size_t b) { return pci(a) < pci(b); });
  auto is_same = [&](size_t a, size_t b) { return !pci(a).empty() && pci(a) == pci(b); };
  gpus.erase(std::unique(gpus.begin(), gpus.end(), is_same), gpus.end());
  return gpus;
}

size_t deviceOfJob(const std::vector<DeviceInfo>& devices, const std::string& visible) {
  const std::vector<size_t> gpus = gpusInPciOrder(devices);
  if (gpus.empty()) return 0;
  const std::string first = visible.substr(0, visible.find(','));
  if (isNumber(first) && first.size() < 9 && std::stoul(first) < gpus.size()) return gpus[std::stoul(first)];
  for (size_t gpu : gpus)
    if (const std::string uuid = uuidIn(first); !uuid.empty() && devices[gpu].uuid.starts_with(uuid)) return gpu;
  if (first.empty() || first == "-1" || first == "NoDevFiles") {  // a job without a GPU
    auto software = std::find_if(devices.begin(), devices.end(), [](const DeviceInfo& one) { return one.software; });
    if (software != devices.end()) return size_t(software - devices.begin());
  }
  throw Error(fmt::format("CUDA_VISIBLE_DEVICES={} matches none of the {} GPUs here; --device chooses one", visible,
                          gpus.size()),
              {}, 2);
}

}  // namespace

std::string uuidText(const uint8_t (&bytes)[16]) {
  std::string text;
  for (size_t i = 0; i < 16; ++i)
    text += fmt::format("{}{:02x}", i == 4 || i == 6 || i == 8 || i == 10 ? "-" : "", bytes[i]);
  return text;
}

std::string pciText(uint32_t domain, uint32_t bus, uint32_t device, uint32_t function) {
  return fmt::format("{:04x}:{:02x}:{:02x}.{:x}", domain, bus, device, function);
}

std::optional<std::string> gpusOfJob() {
  const char* visible = std::getenv("SLURM_JOB_ID") ? std::getenv("CUDA_VISIBLE_DEVICES") : nullptr;
  return visible ? std::optional<std::string>(visible) : std::nullopt;
}

size_t chosenDevice(const std::vector<DeviceInfo>& devices, const std::string& wanted,
                    const std::optional<std::string>& of_job) {
  if (wanted.empty()) return of_job ? deviceOfJob(devices, *of_job) : 0;
  if (isNumber(wanted)) {
    const size_t index = wanted.size() < 9 ? std::stoul(wanted) : devices.size();
    if (index < devices.size()) return index;
    throw Error(fmt::format("--device {}: the first device is 0, the last one {}", wanted, devices.size() - 1), {}, 2);
  }
  for (size_t i = 0; i < devices.size(); ++i)
    if (matches(devices[i], wanted)) return i;
  std::vector<std::string> names;
  for (const DeviceInfo& device : devices) names.push_back("'" + device.name + "'");
  throw Error(fmt::format("--device '{}' matches none of {}", wanted, fmt::join(names, ", ")), {}, 2);
}

}  // namespace strobe::gpu
