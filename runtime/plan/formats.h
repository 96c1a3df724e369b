// SPDX-License-Identifier: MIT
// The texel formats a pass may write, by the name used in Lua, in plans and in records.
#pragma once

#include <string>
#include <vector>

namespace strobe::plan {

struct Format {
  std::string name;  // "rgba16f"
  int channels = 0;
  int bytes = 0;      // of one texel
  bool uint = false;  // unsigned integers, sampled as such
};

// Formats a port may have, in the order in which they are listed to people.
const std::vector<Format>& portFormats();

// The format of that name, also "d32f" (the depth attachment of a raster pass); nullptr when there is none.
const Format* findFormat(const std::string& name);

}  // namespace strobe::plan
