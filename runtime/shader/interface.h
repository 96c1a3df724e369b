// SPDX-License-Identifier: MIT
// From a pass's declared names to the GLSL its shader starts with, so that shaders name things and number nothing.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "shader/backends.h"
#include "shader/compiler.h"

namespace strobe::shader {

// What a shader can name, with the binding numbers of set 1: params 0, counters 1, then reads, then images.
struct Interface {
  struct Read {
    std::string name;
    bool uint = false;
    bool wired = true;  // false: an optional read left open; HAS_<name> is 0 and nothing may be fetched
    bool buffer = false;
    bool over = false;        // where it is wired, the pass runs for the pixels that are its entries
    std::string absent = {};  // GLSL of a texel if it is not wired; "": there is no function <name>_at then
  };
  struct Write {
    std::string name;
    std::string format;  // layout qualifier: "rgba16f", "r8", ...
    bool uint = false;
    bool update = false;      // read and written
    std::string texels = {};  // the format by the name used in Lua: "r8_unorm"
    bool buffer = false;
  };
  struct Param {
    std::string name;
    bool integer = false;
  };
  // A value compiled in: `#define PARAM_<name> <index>` and `#define <name>_<choice> <i>` for each choice; of a bool
  // the index is 0 or 1 and there are no choices.
  struct Variant {
    std::string name;
    std::vector<std::string> choices;
    int64_t index = 0;
    bool decides_format = false;  // of an image the pass writes: the shader need not name it
  };
  std::string pass;
  std::string place;  // of the pass's declaration, for errors
  bool raster = false;
  bool scene = false;
  std::vector<std::pair<std::string, bool>> facts;  // of the scene it sees: `#define FACT_<name> 0` or 1
  Backend backend = Backend::None;
  bool doubles = false;             // trace: the device computes at double precision
  bool deal_rows = false;           // compute: groups next to each other are not dispatched one after the other
  bool group = false;               // compute: a work group for each pixel
  bool static_once = false;         // in iterations after the first: on the pixels of frame.moving_rect alone
  bool in_moving_rect = false;      // on these in every iteration
  bool separate_triangles = false;  // raster: vertices are not indexed, and number the triangles
  uint32_t slices = 1;              // poses the scene's arrays hold
  uint32_t time_slice = 0;          // the one this node sees
  std::vector<Read> reads;
  std::vector<Write> writes;
  std::vector<Param> params;  // 4 bytes each, in this order
  std::vector<Variant> variants;
  std::vector<std::string> counters;  // a trace pass has "rays_" and its backend added by the caller

  static constexpr uint32_t kParamsBinding = 0, kCountersBinding = 1, kFirstImageBinding = 2;
  // The read whose entries it runs for; null: it runs for all pixels.
  const Read* over() const;
  // Without an image among its writes its size is a parameter of the runtime's, behind its own.
  bool sizeIsGiven() const;
  bool hasParams() const { return !params.empty() || sizeIsGiven(); }
  uint32_t readBinding(size_t index) const { return kFirstImageBinding + uint32_t(index); }
  uint32_t writeBinding(size_t index) const { return kFirstImageBinding + uint32_t(reads.size() + index); }
};

// Side of a compute work group, invocations.
constexpr uint32_t kGroupSize = 8;

std::string preamble(const Interface& interface, Stage stage);
std::string epilogue(const Interface& interface, Stage stage);

// Every name in the code of shader files and what they include, under any choice; of members also "params.x". Comments
// do not count.
std::unordered_set<std::string> namesUsed(const Home& home, const std::vector<Path>& shader_files,
                                          Sources* sources = nullptr);

// Declared names that are not among `used`, the names in `shader_files`, and names in `used` that parameters are
// compared with although they are not their choices. Each with both places.
std::vector<std::string> nameProblems(const Home& home, const Interface& interface,
                                      const std::vector<Path>& shader_files,
                                      const std::unordered_set<std::string>& used);

// Compiles `file` as `stage` of the pass; errors about unknown names say what the pass declares.
Compiled compilePass(const Home& home, const Interface& interface, const Path& file, Stage stage,
                     Output output = Output::Spirv, Sources* sources = nullptr);

}  // namespace strobe::shader
