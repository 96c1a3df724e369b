// SPDX-License-Identifier: MIT
// Compiler from GLSL to SPIR-V in this process (glslang), with a cache on disk. Reports errors at the user's lines.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/home.h"

namespace strobe::shader {

class Sources;

// Pipeline stage that a shader is compiled for: raster, compute or ray tracing.
enum class ShaderStage { Vertex, Fragment, Compute, RayGeneration, Miss, ClosestHit, AnyHit };

// Result of a compilation. Mistakes are found before SPIR-V is generated, so a check does not need SPIR-V.
enum class Output { Spirv, None };

// GLSL to compile: a file, with generated code before and after it.
struct ShaderSource {
  std::string preamble;  // generated declarations before the file; not counted in line numbers
  Path file;             // shader text of the pass, below shaders/ or elsewhere
  std::string epilogue;  // generated code after the file
};

// Compiles a shader. Throws `Error` with a line "file:line: message" for each error of the compiler.
// `#include "a/b.glsl"` is looked up in the folder of the including file, then in the shaders folder.
// `sources` (may be null) keeps the files for later calls.
std::vector<uint32_t> compile(const Home& home, const ShaderSource& source, ShaderStage stage,
                              Output output = Output::Spirv, Sources* sources = nullptr);

// Compiles GLSL of the program itself, without includes. Throws `Error`.
std::vector<uint32_t> compileText(const std::string& glsl, ShaderStage stage);

// Joined text of `file` and all files that it includes, for checks without the compiler. `files` receives the paths.
std::string textWithIncludes(const Home& home, const Path& file, std::vector<Path>* files = nullptr,
                             Sources* sources = nullptr);

}  // namespace strobe::shader
