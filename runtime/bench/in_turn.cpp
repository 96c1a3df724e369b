// SPDX-License-Identifier: MIT
#include "bench/in_turn.h"

#include "base/process.h"

namespace strobe::bench {

// Last line of a program's output, with the reason of its end.
static std::string lastLine(std::string text) {
  while (text.ends_with('\n')) text.pop_back();
  size_t before = text.rfind('\n');
  return before == std::string::npos ? text : text.substr(before + 1);
}

static Run runOf(const std::string& program, const std::vector<std::string>& arguments) {
  Program child;
  child.arguments = {program};
  child.arguments.insert(child.arguments.end(), arguments.begin(), arguments.end());
  ProgramEnd end = run(child);
  if (!end.succeeded())
    throw Error(fmt::format("cannot run these shots: exit code {}, '{}'", end.code(), lastLine(end.errors)), {program});
  return runFrom(Json::parse(end.output, nullptr, false), program + " bench frames");
}

Turns runInTurn(const std::string& first, const std::string& second, const std::vector<std::string>& arguments,
                int blocks, const std::function<void(int done)>& progress) {
  Turns turns;
  for (int block = 0; block < blocks; ++block) {
    for (int turn = 0; turn < 2; ++turn) {
      bool is_first = turn == block % 2;
      (is_first ? turns.first : turns.second).push_back(runOf(is_first ? first : second, arguments));
    }
    requireSameShots(turns.first.back(), turns.second.back(), second);
    progress(block + 1);
  }
  return turns;
}

}  // namespace strobe::bench
