// SPDX-License-Identifier: MIT
// Script children, on the side of the parent.
#pragma once

#include <string>

#include "base/home.h"
#include "base/process.h"
#include "script/evaluate.h"

namespace strobe::script {

// Exit status of a child that could not allocate memory for its answer.
inline constexpr int kOutOfMemory = 4;

// Starts `program --script-child` within `limits`, or takes a waiting child. Writes `input` to its stdin and waits for
// its end. Throws `Error` if the process cannot be started.
ProgramEnd runChild(const Path& program, const std::string& input, const Limits& limits);

// A child for batches (script/batch.h): a waiting child, or a new one.
WaitingProgram startedChild(const Path& program, const Limits& limits);

// Starts children until `count` children with these limits wait for requests. A later `runChild` with these limits
// takes a waiting child, which has read `files` that did not change since. Each child answers one request. The calling
// thread must continue to run, because the system ends the children with the thread that started them.
void expectChildren(const Home& home, const Limits& limits, size_t count, const std::vector<Dependency>& files = {});

}  // namespace strobe::script
