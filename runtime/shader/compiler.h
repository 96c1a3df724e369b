// SPDX-License-Identifier: MIT
// GLSL to SPIR-V in process (glslang), with the files a shader came from and errors at the user's own lines.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/home.h"

namespace strobe::shader {

class Sources;

enum class Stage { Vertex, Fragment, Compute, RayGeneration, Miss, ClosestHit, AnyHit };

// Mistakes are found ahead of the making of SPIR-V, which a check goes without.
enum class Output { Spirv, None };

struct Source {
  std::string preamble;  // generated declarations; not part of the user's line numbers
  Path file;             // below shaders/ or anywhere; the text of the pass
  std::string epilogue;  // generated code behind it
};

struct Compiled {
  std::vector<uint32_t> spirv;
  std::vector<Path> files;  // `file` and everything it includes, in order of first use
};

// Throws `Error` whose lines each read "file:line: message", all of the compiler's errors at once.
// `#include "a/b.glsl"` is looked up beside the including file, then in the shaders folder.
// `sources` (may be null) remembers files between calls.
Compiled compile(const Home& home, const Source& source, Stage stage, Output output = Output::Spirv,
                 Sources* sources = nullptr);

// The program's own GLSL, without includes. Throws `Error`.
std::vector<uint32_t> compileText(const std::string& glsl, Stage stage);

// Every file `file` reaches through includes, and their joined text; for checks that need no compiler.
std::string textWithIncludes(const Home& home, const Path& file, std::vector<Path>* files = nullptr,
                             Sources* sources = nullptr);

}  // namespace strobe::shader
