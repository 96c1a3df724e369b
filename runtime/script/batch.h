// SPDX-License-Identifier: MIT
// Evaluation of many requests in few child processes. A child starts once and forks for each request, so each script
// has its own limits and its own end. Requests for one file fork from a process that has loaded the file.
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

// Result of one request of a batch.
struct Answer {
  ProgramEnd end;                             // end of the process of this request
  std::shared_ptr<const std::string> shared;  // data loaded once for several requests; null without
  bool is_lost = false;                       // the child ended without an answer, or was ended after the time limit
};

// Child processes that share the requests, one per core of the machine. Loaded files are kept for later requests, with
// the contents at the first read. The children end with this object, or with the thread that sent the first request.
class Children {
 public:
  // `limits` apply to each request.
  Children(const Path& program, const Limits& limits) : program_(program), limits_(limits) {}

  // Answers in the order of `requests`.
  std::vector<Answer> answers(const std::vector<Json>& requests);

 private:
  struct Child {
    explicit Child(WaitingProgram program) : program(std::move(program)) {}
    WaitingProgram program;
    bool is_lost = false;                                      // the child has not answered all requests
    std::map<int, std::shared_ptr<const std::string>> loaded;  // loaded data by number, as in the answers
    std::set<std::string> asked_for;  // earlier requests of this child, without their arguments
  };
  // Indices of requests per child. Requests for one file go to few children, while all children have work.
  std::vector<std::vector<size_t>> dealt(const std::vector<Json>& requests, size_t shares);
  std::vector<Answer> ask(Child& child, const std::vector<Json>& requests) const;

  Path program_;
  Limits limits_;
  std::vector<std::unique_ptr<Child>> children_;
};

// Functions of a script process for its requests: answer one request, test if several requests can share loaded data,
// and load that data.
struct Answering {
  std::function<void(const Json&)> evaluate;  // answers a request on stdout and ends the process
  // True if a request of this kind has data that can be loaded once for several requests.
  std::function<bool(const Json&)> loads;
  // Loads the data of requests that differ in their argument only, and returns the data that their answers refer to. If
  // it returns nothing, or ends the process with a status other than 0, each request is evaluated from the start.
  std::function<std::optional<std::string>(const Json&)> load;
};

// In the child: answers `line`, then each further line of stdin until its end.
[[noreturn]] void answerBatches(std::string line, const Answering& answering);

// A line of stdin without its line end, or the rest of the input if that has no line end; nothing at the end of the
// input.
std::optional<std::string> readLine();

}  // namespace strobe::script
