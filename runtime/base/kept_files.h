// SPDX-License-Identifier: MIT
// Cache of files on disk between runs. Each file is stored under a hash of everything it was made of, so that a stale
// file is never found.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "base/files.h"

namespace strobe {

// Folder of cached files, found by key, with a limit on their total size (default 256 MiB) beyond which the oldest are
// removed.
class KeptFiles {
 public:
  static constexpr size_t kMost = size_t(256) << 20;

  // `folder` may be missing; an empty path keeps nothing. If the files exceed `most` bytes, the oldest are removed. The
  // size is checked once per `most` / 4 new bytes.
  explicit KeptFiles(Path folder, size_t most = kMost) : folder_(std::move(folder)), most_(most) {}

  // Content stored under this key; nothing if the file is missing or damaged.
  std::optional<std::string> find(const std::string& key) const;
  // Does nothing if the file cannot be written.
  void keep(const std::string& key, std::string_view bytes) const;

  // If the files exceed `most` bytes, removes the oldest until three quarters of `most` are left.
  void makeRoom() const;

 private:
  Path folder_;
  size_t most_;
};

}  // namespace strobe
