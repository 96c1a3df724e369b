// SPDX-License-Identifier: MIT
// The parent's side of a script child.
#pragma once

#include <string>

#include "base/process.h"

namespace strobe::script {

struct Limits;

// Exit status of a child that found no memory for its answer.
inline constexpr int kOutOfMemory = 4;

// Starts `program --script-child` within `limits`, hands it `input` on stdin and waits for its end. Throws `Error`
// where no process can be started.
ProgramEnd runChild(const Path& program, const std::string& input, const Limits& limits);

}  // namespace strobe::script
