// SPDX-License-Identifier: MIT
#include "base/kept_files.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include "base/hash.h"

namespace strobe {

namespace fs = std::filesystem;

namespace {

constexpr size_t kHashDigits = 32;

// True if the size must be checked: before the first file that this process keeps in the folder, and again after every
// `step` bytes.
bool isDue(const Path& folder, size_t bytes, size_t step) {
  static std::mutex mutex;
  static std::map<Path, size_t> left;
  std::lock_guard lock(mutex);
  const auto [one, is_first] = left.emplace(folder, step);
  const bool due = is_first || one->second < bytes;
  one->second = due ? step : one->second - bytes;
  return due;
}

}  // namespace

std::optional<std::string> KeptFiles::find(const std::string& key) const {
  std::error_code ignored;
  if (folder_.empty() || !fs::is_regular_file(folder_ / key, ignored)) return std::nullopt;
  std::string text;
  try {
    text = readText(folder_ / key);
  } catch (const Error&) {
    return std::nullopt;
  }
  const std::string_view whole = text;
  if (whole.size() < kHashDigits || hashText(whole.substr(kHashDigits)) != whole.substr(0, kHashDigits))
    return std::nullopt;
  text.erase(0, kHashDigits);
  return text;
}

void KeptFiles::keep(const std::string& key, std::string_view bytes) const {
  if (folder_.empty()) return;
  const std::string whole = hashText(bytes).append(bytes);
  if (isDue(folder_, whole.size(), most_ / 4)) makeRoom();
  try {
    writeFileAtomically(folder_ / key, whole, Flush::no);
  } catch (const Error&) {
    // An unwritable folder costs time only.
  }
}

void KeptFiles::makeRoom() const {
  struct File {
    fs::file_time_type written;
    Path path;
    size_t bytes;
  };
  std::vector<File> files;
  size_t bytes = 0;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder_, failed)) {
    const File file{entry.last_write_time(failed), entry.path(), size_t(entry.file_size(failed))};
    if (failed) continue;  // another process removed it
    files.push_back(file);
    bytes += file.bytes;
  }
  if (bytes <= most_) return;
  std::sort(files.begin(), files.end(), [](const File& a, const File& b) { return a.written < b.written; });
  for (size_t i = 0; i < files.size() && bytes > most_ / 4 * 3; ++i) {
    fs::remove(files[i].path, failed);
    bytes -= files[i].bytes;
  }
}

}  // namespace strobe
