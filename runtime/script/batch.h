// SPDX-License-Identifier: MIT
// Many evaluations in few child processes: each child starts once and forks for every request, so that every script has
// limits and an end of its own. Requests for the same file fork from a process that has loaded it.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/json_fwd.h"
#include "script/evaluate.h"
#include "script/process.h"

namespace strobe::script {

// How one of many ended.
struct Answer {
  ProgramEnd end;                             // as `runChild` gives it
  std::shared_ptr<const std::string> shared;  // what was loaded for it and others alike; null where nothing was
  bool is_lost = false;                       // the child ended without it, or was ended after too long
};

// As many children as the machine has cores share the requests. What they loaded for some, they keep for later ones: a
// file counts as it was when it was read first. They end with this object, and with the thread that asked them first.
class Children {
 public:
  // `limits` are those of one request.
  Children(const Path& program, const Limits& limits) : program_(program), limits_(limits) {}

  // That of each request, in their order.
  std::vector<Answer> answers(const std::vector<Json>& requests);

 private:
  struct Child {
    explicit Child(WaitingProgram program) : program(std::move(program)) {}
    WaitingProgram program;
    bool is_lost = false;                                      // it has not answered all
    std::map<int, std::shared_ptr<const std::string>> loaded;  // what answers refer to, by the number it goes by
    std::set<std::string> asked_for;                           // requests without their arguments
  };
  // Which child gets which requests: as few load the same as keeps all at work.
  std::vector<std::vector<size_t>> dealt(const std::vector<Json>& requests, size_t shares);
  std::vector<Answer> ask(Child& child, const std::vector<Json>& requests) const;

  Path program_;
  Limits limits_;
  std::vector<std::unique_ptr<Child>> children_;
};

struct Answering {
  std::function<void(const Json&)> evaluate;  // answers a request on stdout and ends the process
  // Whether requests of a kind have anything in common that is worth loading.
  std::function<bool(const Json&)> loads;
  // Does what requests that differ in their argument alone have in common, and yields what their answers refer to.
  // Nothing, or the end of the process with a status other than 0: each of them is then evaluated from the start.
  std::function<std::optional<std::string>(const Json&)> load;
};

// The child's side: what a line of its input asks, then the next one, until there is none.
[[noreturn]] void answerBatches(std::string line, const Answering& answering);

// A line of stdin without its end, or what there is before the end of all; nothing at the end.
std::optional<std::string> readLine();

}  // namespace strobe::script
