// SPDX-License-Identifier: MIT
#include "base/hash.h"

#include <fmt/format.h>
#include <xxhash.h>

namespace strobe {

std::string hashBytes(const void* data, size_t size) {
  XXH128_hash_t hash = XXH3_128bits(data, size);
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

std::string hashText(std::string_view text) { return hashBytes(text.data(), text.size()); }

}  // namespace strobe
