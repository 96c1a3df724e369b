// SPDX-License-Identifier: MIT
#include "base/memory.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

namespace strobe {

namespace {

constexpr uint64_t kUnlimited = UINT64_MAX;

// First number of each line, by the line's first word: "MemAvailable: 12 kB", "inactive_file 4096".
std::map<std::string, uint64_t> numbersByName(const Path& file) {
  std::map<std::string, uint64_t> numbers;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string name;
    if (uint64_t number = 0; words >> name >> number) numbers[name] = number;
  }
  return numbers;
}

// Number at the beginning of a file; nothing if the file is missing or holds a word ("max").
std::optional<uint64_t> numberIn(const Path& file) {
  std::ifstream stream(file);
  uint64_t number = 0;
  return stream >> number ? std::optional(number) : std::nullopt;
}

uint64_t leftOfSystem(const Path& root) {
  std::map<std::string, uint64_t> numbers = numbersByName(root / "proc/meminfo");
  if (!numbers.count("MemAvailable:")) return kUnlimited;
  return 1024 * (numbers["MemAvailable:"] + numbers["SwapFree:"]);
}

// Files and counters in the two versions of control groups.
struct GroupFiles {
  const char *limit, *usage, *inactive, *active;
};
constexpr GroupFiles kFirstVersion = {"memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file",
                                      "total_active_file"};
constexpr GroupFiles kSecondVersion = {"memory.max", "memory.current", "inactive_file", "active_file"};

// Memory left in a group. Cached pages of files count as free: the system frees them on demand.
uint64_t leftOfGroup(const Path& folder, const GroupFiles& files) {
  std::optional<uint64_t> limit = numberIn(folder / files.limit), usage = numberIn(folder / files.usage);
  if (!limit || !usage) return kUnlimited;
  std::map<std::string, uint64_t> stat = numbersByName(folder / "memory.stat");
  const uint64_t cached = stat[files.inactive] + stat[files.active];
  const uint64_t used = *usage - std::min(cached, *usage);
  return *limit - std::min(used, *limit);
}

// Memory left in a group and in all groups above it, the smallest.
uint64_t leftOfGroups(const Path& mount, const Path& group, const GroupFiles& files) {
  uint64_t left = kUnlimited;
  for (Path at = group.relative_path();; at = at.parent_path()) {
    left = std::min(left, leftOfGroup(mount / at, files));
    if (at.empty()) return left;
  }
}

bool hasMemory(const std::string& controllers) {
  return ("," + controllers + ",").find(",memory,") != std::string::npos;
}

}  // namespace

// Lines of /proc/self/cgroup: "4:memory:/group" of the first version, "0::/group" of the second.
uint64_t availableMemory(const Path& root) {
  uint64_t left = leftOfSystem(root);
  std::ifstream groups(root / "proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    const size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1), group = line.substr(second + 1);
    if (controllers.empty()) left = std::min(left, leftOfGroups(root / "sys/fs/cgroup", group, kSecondVersion));
    if (hasMemory(controllers))
      left = std::min(left, leftOfGroups(root / "sys/fs/cgroup/memory", group, kFirstVersion));
  }
  return left;
}

std::string bytesText(uint64_t bytes) {
  if (bytes >= uint64_t{1} << 30) return fmt::format("{:.1f} GiB", double(bytes) / double(1 << 30));
  if (bytes >= uint64_t{1} << 20) return fmt::format("{} MiB", bytes >> 20);
  if (bytes >= uint64_t{1} << 10) return fmt::format("{} KiB", bytes >> 10);
  return fmt::format("{} bytes", bytes);
}

}  // namespace strobe
