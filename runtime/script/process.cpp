// SPDX-License-Identifier: MIT
#include "script/process.h"

#include <cstdlib>

#include "base/error.h"
#include "script/evaluate.h"

namespace strobe::script {

static constexpr const char* kInsideChild = "STROBE_SCRIPT_CHILD";

// The child stops a script itself, with a line, at its limits; those of the process are a little wider and stop what
// never returns to Lua's loop (a long library call, a finalizer).
ProgramEnd runChild(const Path& path, const std::string& input, const Limits& limits) {
  // A program that does not know the option would evaluate again, and so on without end.
  if (std::getenv(kInsideChild)) throw Error("a script child was asked to start another; is STROBE_PROGRAM strobe?");
  Program program{.arguments = {path.string(), "--script-child"},
                  .environment = {std::string(kInsideChild) + "=1"},
                  .input = input,
                  .errors = Program::Errors::inherited,
                  .wall_s = limits.wall_s,
                  .cpu_s = limits.cpu_s + 0.25};
#ifndef __SANITIZE_ADDRESS__  // which cannot run in a limited address space
  program.memory_bytes = static_cast<size_t>(limits.memory_mb) << 21;
#endif
  return run(program);
}

}  // namespace strobe::script
