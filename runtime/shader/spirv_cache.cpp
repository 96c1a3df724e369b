// SPDX-License-Identifier: MIT
#include "shader/spirv_cache.h"

#include <algorithm>
#include <cstring>
#include <mutex>

#include "base/hash.h"

namespace strobe::shader {

namespace fs = std::filesystem;

namespace {

constexpr size_t kHashDigits = 32;

void append(std::string& bytes, const std::vector<uint32_t>& words) {
  const uint32_t count = uint32_t(words.size());
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  bytes.append(reinterpret_cast<const char*>(words.data()), words.size() * sizeof(uint32_t));
}

// Reads what `append` wrote and moves on; false where there is less.
bool take(std::string_view& bytes, std::vector<uint32_t>& words) {
  uint32_t count = 0;
  if (bytes.size() < sizeof count) return false;
  std::memcpy(&count, bytes.data(), sizeof count);
  bytes.remove_prefix(sizeof count);
  const size_t size = size_t(count) * sizeof(uint32_t);
  if (bytes.size() < size) return false;
  words.resize(count);
  std::memcpy(words.data(), bytes.data(), size);
  bytes.remove_prefix(size);
  return true;
}

}  // namespace

bool SpirvCache::empty() const {
  std::error_code none;
  return folder_.empty() || fs::directory_iterator(folder_, none) == fs::directory_iterator();
}

std::optional<KeptCode> SpirvCache::find(const std::string& key) const {
  std::error_code ignored;
  if (folder_.empty() || !fs::is_regular_file(folder_ / key, ignored)) return std::nullopt;
  std::string text;
  try {
    text = readText(folder_ / key);
  } catch (const Error&) {
    return std::nullopt;
  }
  std::string_view bytes = text;
  if (bytes.size() < kHashDigits || hashText(bytes.substr(kHashDigits)) != bytes.substr(0, kHashDigits))
    return std::nullopt;
  bytes.remove_prefix(kHashDigits);
  KeptCode code;
  if (!take(bytes, code.files) || !take(bytes, code.spirv)) return std::nullopt;
  return code;
}

void SpirvCache::keep(const std::string& key, const KeptCode& code) const {
  if (folder_.empty()) return;
  static std::once_flag once;
  std::call_once(once, [this] { makeRoom(); });
  std::string bytes;
  append(bytes, code.files);
  append(bytes, code.spirv);
  try {
    writeFileAtomically(folder_ / key, hashText(bytes) + bytes, Flush::no);
  } catch (const Error&) {
    // A folder that cannot be written costs time, no more.
  }
}

void SpirvCache::makeRoom(size_t most) const {
  std::vector<std::pair<fs::file_time_type, Path>> files;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder_, ignored))
    files.emplace_back(entry.last_write_time(ignored), entry.path());
  if (files.size() <= most) return;
  std::sort(files.begin(), files.end());
  for (size_t i = 0; i < files.size() - most / 4 * 3; ++i) fs::remove(files[i].second, ignored);
}

}  // namespace strobe::shader
