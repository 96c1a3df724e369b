// SPDX-License-Identifier: MIT
// SPIR-V kept on disk from run to run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/kept_files.h"

namespace strobe::shader {

// One shader that compiled.
struct KeptCode {
  std::vector<uint32_t> spirv;  // empty where it was checked alone
  std::vector<uint32_t> files;  // numbers, among the files that its includes reach, of those that were included
};

class SpirvCache {
 public:
  // In "spirv" below `folder`; an empty one keeps nothing.
  explicit SpirvCache(const Path& folder) : files_(folder.empty() ? folder : folder / "spirv") {}

  bool empty() const { return files_.empty(); }
  std::optional<KeptCode> find(const std::string& key) const;
  void keep(const std::string& key, const KeptCode& code) const;

 private:
  KeptFiles files_;
};

}  // namespace strobe::shader
