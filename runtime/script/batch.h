// SPDX-License-Identifier: MIT
// Many evaluations in few child processes: each child starts once and forks for every request, so that every script has
// a Lua state, limits and an end of its own.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/json.h"
#include "script/process.h"

namespace strobe::script {

// What `runChild` gives for each of `requests`, in their order; `limits` are those of one of them. As many children as
// the machine has cores share the work.
std::vector<ProgramEnd> runChildren(const Path& program, const std::vector<Json>& requests, const Limits& limits);

// The child's side, for a request that `isBatch`: `evaluate` answers one of its requests on stdout and ends the
// process.
bool isBatch(const Json& request);
[[noreturn]] void answerBatch(const Json& batch, const std::function<void(const Json&)>& evaluate);

}  // namespace strobe::script
