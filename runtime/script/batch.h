// SPDX-License-Identifier: MIT
// Many evaluations in few child processes: each child starts once and forks for every request, so that every script has
// limits and an end of its own. Requests for the same file fork from a process that has loaded it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "script/process.h"

namespace strobe::script {

// How one of many ended.
struct Answer {
  ProgramEnd end;                             // as `runChild` gives it
  std::shared_ptr<const std::string> shared;  // what was loaded for it and others alike; null where nothing was
};

// That of each of `requests`, in their order; `limits` are those of one of them. As many children as the machine has
// cores share the work.
std::vector<Answer> runChildren(const Path& program, const std::vector<Json>& requests, const Limits& limits);

struct Answering {
  std::function<void(const Json&)> evaluate;  // answers a request on stdout and ends the process
  // Does what requests that differ in their argument alone have in common, and yields what their answers refer to.
  // Nothing, or the end of the process with a status other than 0: each of them is then evaluated from the start.
  std::function<std::optional<std::string>(const Json&)> load;
};

// The child's side, for a request that `isBatch`.
bool isBatch(const Json& request);
[[noreturn]] void answerBatch(const Json& batch, const Answering& answering);

}  // namespace strobe::script
