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

// Memory left in a group. Cached pages of files count as free: the system frees them on demand.
uint64_t leftOfGroup(const Path& folder) {
  std::optional<uint64_t> limit = numberIn(folder / "memory.max"), usage = numberIn(folder / "memory.current");
  if (!limit || !usage) return kUnlimited;
  std::map<std::string, uint64_t> stat = numbersByName(folder / "memory.stat");
  const uint64_t cached = stat["inactive_file"] + stat["active_file"];
  const uint64_t used = *usage - std::min(cached, *usage);
  return *limit - std::min(used, *limit);
}

// Memory left in a group and in all groups above it, the smallest.
uint64_t leftOfGroups(const Path& mount, const Path& group) {
  uint64_t left = kUnlimited;
  for (Path at = group.relative_path();; at = at.parent_path()) {
    left = std::min(left, leftOfGroup(mount / at));
    if (at.empty()) return left;
  }
}

}  // namespace

// Control groups of version 2: the line "0::/group" of /proc/self/cgroup.
uint64_t availableMemory(const Path& root) {
  uint64_t left = leftOfSystem(root);
  std::ifstream groups(root / "proc/self/cgroup");
  for (std::string line; std::getline(groups, line);)
    if (line.starts_with("0::")) left = std::min(left, leftOfGroups(root / "sys/fs/cgroup", line.substr(3)));
  return left;
}

std::string bytesText(uint64_t bytes) {
  if (bytes >= uint64_t{1} << 30) return fmt::format("{:.1f} GiB", double(bytes) / double(1 << 30));
  if (bytes >= uint64_t{1} << 20) return fmt::format("{} MiB", bytes >> 20);
  if (bytes >= uint64_t{1} << 10) return fmt::format("{} KiB", bytes >> 10);
  return fmt::format("{} bytes", bytes);
}

}  // namespace strobe
