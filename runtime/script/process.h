// SPDX-License-Identifier: MIT
// The parent's side of a script child.
#pragma once

#include <string>

#include "base/home.h"
#include "base/process.h"

namespace strobe::script {

struct Dependency;
struct Limits;

// Exit status of a child that found no memory for its answer.
inline constexpr int kOutOfMemory = 4;

// Starts `program --script-child` within `limits`, or takes one that waits, hands it `input` on stdin and waits for its
// end. Throws `Error` where no process can be started.
ProgramEnd runChild(const Path& program, const std::string& input, const Limits& limits);

// A child that waits for batches (script/batch.h), one already started if there is one; else as `runChild`.
WaitingProgram startedChild(const Path& program, const Limits& limits);

// Starts so many children ahead of their requests, less those that wait already: `runChild` with these limits then
// waits for no start, nor for the reading of those `files` that stay as they are. Each answers one request, as any
// child. To be called from a thread that goes on, since the system ends children with the thread that started them.
void expectChildren(const Home& home, const Limits& limits, size_t count, const std::vector<Dependency>& files = {});

}  // namespace strobe::script
