// SPDX-License-Identifier: MIT
#include "shader/spirv_cache.h"

#include <cstring>

namespace strobe::shader {

namespace {

void append(std::string& bytes, const std::vector<uint32_t>& words) {
  const uint32_t count = uint32_t(words.size());
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  bytes.append(reinterpret_cast<const char*>(words.data()), words.size() * sizeof(uint32_t));
}

// Reads data that `append` wrote, and advances `bytes`. False if `bytes` is too short.
bool take(std::string_view& bytes, std::vector<uint32_t>& words) {
  uint32_t count = 0;
  if (bytes.size() < sizeof count) return false;
  std::memcpy(&count, bytes.data(), sizeof count);
  bytes.remove_prefix(sizeof count);
  const size_t size = size_t(count) * sizeof(uint32_t);
  if (bytes.size() < size) return false;
  words.resize(count);
  if (size > 0) std::memcpy(words.data(), bytes.data(), size);
  bytes.remove_prefix(size);
  return true;
}

}  // namespace

std::optional<KeptCode> SpirvCache::find(const std::string& key) const {
  const std::optional<std::string> kept = files_.find(key);
  if (!kept) return std::nullopt;
  std::string_view bytes = *kept;
  KeptCode code;
  if (!take(bytes, code.files) || !take(bytes, code.spirv)) return std::nullopt;
  return code;
}

void SpirvCache::keep(const std::string& key, const KeptCode& code) const {
  std::string bytes;
  append(bytes, code.files);
  append(bytes, code.spirv);
  files_.keep(key, bytes);
}

}  // namespace strobe::shader
