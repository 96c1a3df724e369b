// SPDX-License-Identifier: MIT
#include "script/process.h"

#include <cstdlib>
#include <list>
#include <mutex>
#include <optional>

#include "base/error.h"
#include "base/json.h"
#include "script/evaluate.h"

namespace strobe::script {

static constexpr const char* kInsideChild = "STROBE_SCRIPT_CHILD";

// The child ends a script that exceeds its limits, with the line in the error. The limits of the process are wider and
// end calls that do not return to Lua's loop (a long library call).
static Program childOf(const Path& path, const Limits& limits) {
  // A program without the option --script-child would evaluate again, and so recurse without end.
  if (std::getenv(kInsideChild))
    throw Error("a script child cannot start another one; check that STROBE_PROGRAM is strobe");
  Program program{.arguments = {path.string(), "--script-child"},
                  .environment = {std::string(kInsideChild) + "=1"},
                  .errors = Program::Errors::inherited,
                  .wall_s = limits.wall_s,
                  .cpu_s = limits.cpu_s + 0.25};
#ifndef __SANITIZE_ADDRESS__  // AddressSanitizer cannot run in a limited address space
  program.memory_bytes = static_cast<size_t>(limits.memory_mb) << 21;
#endif
  return program;
}

// Input line with the files that a child reads before its request.
static std::string aheadOf(const Home& home, const Limits& limits, const std::vector<Dependency>& files) {
  Json ahead = Json::array();
  for (const Dependency& file : files) ahead.push_back({{"path", file.path.string()}, {"shown", file.shown}});
  const Json line = {{"ahead", ahead}, {"roots", home.roots()}, {"memory_mb", limits.memory_mb}};
  return line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

static Program expectedChild(const Home& home, const Limits& limits, const std::vector<Dependency>& files) {
  Program program = childOf(home.program(), limits);
  if (!files.empty()) program.input = aheadOf(home, limits, files);
  return program;
}

namespace {

struct ExpectedRun {
  Path path;
  Limits limits;
  WaitingProgram program;

  ExpectedRun(const Home& home, const Limits& limits, const std::vector<Dependency>& files)
      : path(home.program()), limits(limits), program(expectedChild(home, limits, files)) {}
  bool serves(const Path& wanted, const Limits& within) const { return path == wanted && limits == within; }
};

struct AllExpected {
  std::mutex mutex;
  std::list<ExpectedRun> children;
};

AllExpected& allExpected() {
  static AllExpected all;
  return all;
}

// Removes the first waiting child with this program and these limits from the list; empty without one.
std::list<ExpectedRun> taken(const Path& path, const Limits& limits) {
  AllExpected& all = allExpected();
  std::lock_guard lock(all.mutex);
  std::list<ExpectedRun> first;
  for (auto it = all.children.begin(); it != all.children.end(); ++it) {
    if (!it->serves(path, limits) || !it->program.waits()) continue;
    first.splice(first.begin(), all.children, it);
    break;
  }
  return first;
}

}  // namespace

ProgramEnd runChild(const Path& path, const std::string& input, const Limits& limits) {
  std::list<ExpectedRun> expected = taken(path, limits);
  if (!expected.empty()) return expected.front().program.run(input);
  Program program = childOf(path, limits);
  program.input = input;
  return run(program);
}

WaitingProgram startedChild(const Path& path, const Limits& limits) {
  std::list<ExpectedRun> expected = taken(path, limits);
  if (!expected.empty()) return std::move(expected.front().program);
  return WaitingProgram(childOf(path, limits));
}

void expectChildren(const Home& home, const Limits& limits, size_t count, const std::vector<Dependency>& files) {
  AllExpected& all = allExpected();
  std::lock_guard lock(all.mutex);
  all.children.remove_if([](const ExpectedRun& one) { return !one.program.waits(); });
  size_t waiting = 0;
  for (const ExpectedRun& one : all.children) waiting += one.serves(home.program(), limits);
  try {
    for (; waiting < count; ++waiting) all.children.emplace_back(home, limits, files);
  } catch (const Error&) {
    // The request starts its own child then and reports the error.
  }
}

}  // namespace strobe::script
