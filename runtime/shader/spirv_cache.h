// SPDX-License-Identifier: MIT
// Cache of SPIR-V on disk, kept between runs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/kept_files.h"

namespace strobe::shader {

// Code of one shader without errors.
struct KeptCode {
  std::vector<uint32_t> spirv;  // empty if the shader was only checked
  std::vector<uint32_t> files;  // indices of the included files, in the list of all files that its includes name
};

// On-disk cache of compiled shader code, by a text key; empty and inactive without a folder.
class SpirvCache {
 public:
  // The cache is in the folder "spirv" below `folder`; an empty path disables it.
  explicit SpirvCache(const Path& folder) : files_(folder.empty() ? folder : folder / "spirv") {}

  std::optional<KeptCode> find(const std::string& key) const;
  void keep(const std::string& key, const KeptCode& code) const;

 private:
  KeptFiles files_;
};

}  // namespace strobe::shader
