// SPDX-License-Identifier: MIT
// What can be made again, kept on disk from run to run, each file under a hash of all that it was made of: nothing
// stale can be found.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "base/files.h"

namespace strobe {

class KeptFiles {
 public:
  static constexpr size_t kMost = size_t(256) << 20;

  // In `folder`, which need not be there; an empty name keeps nothing. Where there are more than `most` bytes, which is
  // looked at as a quarter of it is new, the oldest files make way.
  explicit KeptFiles(Path folder, size_t most = kMost) : folder_(std::move(folder)), most_(most) {}

  bool empty() const;
  // What was kept under this key; nothing where the file is not there or not whole.
  std::optional<std::string> find(const std::string& key) const;
  // Does nothing where that cannot be written.
  void keep(const std::string& key, std::string_view bytes) const;

  // Removes the oldest files but for three quarters of `most` bytes, where there are more than that.
  void makeRoom() const;

 private:
  Path folder_;
  size_t most_;
};

}  // namespace strobe
