// SPDX-License-Identifier: MIT
// GLSL declarations generated from the declared names of a pass, so that shaders use names and no binding numbers.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "shader/backends.h"
#include "shader/compiler.h"

namespace strobe::shader {

// Names that a shader may use, and their bindings in set 1: params 0, counters 1, then reads, then images.
struct Interface {
  struct Read {
    std::string name;
    bool uint = false;
    bool wired = true;  // false: an optional read without a source; HAS_<name> is 0 and texels must not be fetched
    bool buffer = false;
    bool over = false;        // if wired, the pass runs for the pixels in this buffer
    std::string absent = {};  // GLSL of a texel if not wired; "": without the function <name>_at
  };
  struct Write {
    std::string name;
    std::string format;  // layout qualifier: "rgba16f", "r8", ...
    bool uint = false;
    bool update = false;      // read and written
    std::string texels = {};  // format name in Lua: "r8_unorm"
    bool buffer = false;
  };
  struct Param {
    std::string name;
    bool integer = false;
  };
  // A value compiled into the shader: `#define PARAM_<name> <index>`, and `#define <name>_<choice> <i>` for each
  // choice. A bool has the index 0 or 1 and no choices.
  struct Variant {
    std::string name;
    std::vector<std::string> choices;
    int64_t index = 0;
    bool decides_format = false;  // format of a written image: the shader need not use the name
  };
  std::string pass;
  std::string place;  // place of the pass's declaration, for errors
  bool raster = false;
  bool scene = false;
  std::vector<std::pair<std::string, bool>> facts;  // facts of the frame: `#define FACT_<name> 0` or 1
  Backend backend = Backend::None;
  bool doubles = false;             // trace: the device computes at double precision
  bool deal_rows = false;           // compute: permute the order of the work groups
  bool group = false;               // compute: one work group per pixel
  bool static_once = false;         // in iterations after the first, run on the pixels of frame.moving_rect only
  bool in_moving_rect = false;      // run on these pixels in every iteration
  bool separate_triangles = false;  // raster: vertices are not indexed; the vertex number gives the triangle
  uint32_t slices = 1;              // number of poses in the scene's arrays
  uint32_t time_slice = 0;          // pose of this node
  std::vector<Read> reads;
  std::vector<Write> writes;
  std::vector<Param> params;  // 4 bytes each, in this order
  std::vector<Variant> variants;
  std::vector<std::string> counters;  // for a trace pass, the caller adds "rays_" with the backend

  static constexpr uint32_t kParamsBinding = 0, kCountersBinding = 1, kFirstImageBinding = 2;
  // The read with the pixels that the pass runs for; null if the pass runs for all pixels.
  const Read* over() const;
  // True if no write is an image. The size is then a parameter of the runtime, after the parameters of the pass.
  bool sizeIsGiven() const;
  bool hasParams() const { return !params.empty() || sizeIsGiven(); }
  uint32_t readBinding(size_t index) const { return kFirstImageBinding + uint32_t(index); }
  uint32_t writeBinding(size_t index) const { return kFirstImageBinding + uint32_t(reads.size() + index); }
};

// Side of a compute work group, invocations.
constexpr uint32_t kGroupSize = 8;

std::string preamble(const Interface& interface, ShaderStage stage);
std::string epilogue(const Interface& interface, ShaderStage stage);

// All names in the code of shader files and their includes, for all choices. Members are also listed as "params.x".
// Comments are ignored.
std::unordered_set<std::string> namesUsed(const Home& home, const std::vector<Path>& shader_files,
                                          Sources* sources = nullptr);

// Errors: declared names that are not in `used` (the names in `shader_files`), and names in `used` that are compared
// with a parameter but are not its choices. Each error has both places.
std::vector<std::string> nameProblems(const Home& home, const Interface& interface,
                                      const std::vector<Path>& shader_files,
                                      const std::unordered_set<std::string>& used);

// Compiles `file` as `stage` of the pass. Errors about unknown names list the similar names that the pass declares.
std::vector<uint32_t> compilePass(const Home& home, const Interface& interface, const Path& file, ShaderStage stage,
                                  Output output = Output::Spirv, Sources* sources = nullptr);

}  // namespace strobe::shader
