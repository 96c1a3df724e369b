// SPDX-License-Identifier: MIT
// SPIR-V kept on disk from run to run, each under a hash of all that it was made of: nothing stale can be found.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/files.h"

namespace strobe::shader {

// One shader that compiled.
struct KeptCode {
  std::vector<uint32_t> spirv;  // empty where it was checked alone
  std::vector<uint32_t> files;  // numbers, among the files that its includes reach, of those that were included
};

class SpirvCache {
 public:
  // Files beyond this many, the oldest first, make way for new ones; a shader takes some 10 to 100 KB.
  static constexpr size_t kMost = 4096;

  // In "spirv" below `folder`; an empty one keeps nothing.
  explicit SpirvCache(const Path& folder) : folder_(folder.empty() ? folder : folder / "spirv") {}

  bool empty() const;
  // What was kept under this key; nothing where the file is not there or not whole.
  std::optional<KeptCode> find(const std::string& key) const;
  // Does nothing where that cannot be written.
  void keep(const std::string& key, const KeptCode& code) const;

  // Removes the oldest files but for three quarters of `most`, where there are more than that.
  void makeRoom(size_t most = kMost) const;

 private:
  Path folder_;
};

}  // namespace strobe::shader
