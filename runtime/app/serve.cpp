// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <set>

#include "app/command_line.h"
#include "app/commands.h"
#include "base/error.h"
#include "base/json.h"

namespace strobe::app {
namespace {

// Commands that `serve` runs. Other commands stop on interruption, open a window or start processes.
const std::set<std::string> kServed = {"render", "help", "check", "plan", "compare", "report", "doctor", "complete"};

void requireServed(const std::string& command) {
  if (!kServed.count(command))
    throw Error(fmt::format("serve does not run '{0}'; start it as a command: strobe {0} ...", command), {}, 2);
}

// Standard output of commands, caught in a file in memory. Answers go to the former standard output.
class CaughtOutput {
 public:
  CaughtOutput() : former_(::fdopen(::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0), "w")) {
    const int file = ::memfd_create("output", MFD_CLOEXEC);
    if (!former_ || file < 0 || ::dup2(file, STDOUT_FILENO) < 0) throw Error("cannot redirect the standard output");
    ::close(file);
  }
  ~CaughtOutput() { std::fclose(former_); }
  CaughtOutput(const CaughtOutput&) = delete;

  // Text since the last call.
  std::string take() {
    std::cout.flush();
    std::fflush(stdout);
    std::string text(size_t(::lseek(STDOUT_FILENO, 0, SEEK_CUR)), '\0');
    const ssize_t got = ::pread(STDOUT_FILENO, text.data(), text.size(), 0);
    text.resize(size_t(std::max<ssize_t>(got, 0)));
    if (::lseek(STDOUT_FILENO, 0, SEEK_SET) < 0 || ::ftruncate(STDOUT_FILENO, 0) < 0)
      throw Error("cannot reset the caught output");
    return text;
  }

  // False if the reader is gone.
  bool answer(const std::string& line) {
    return std::fputs((line + "\n").c_str(), former_) >= 0 && std::fflush(former_) == 0;
  }

 private:
  std::FILE* former_;
};

std::vector<std::string> wordsOf(const std::string& line) {
  try {
    return Json::parse(line).at("command").get<std::vector<std::string>>();
  } catch (const Json::exception&) {
    throw Error(R"(a request is one line: {"command": ["render", "PIPELINE", "--size", "320x180", "--json"]})", {}, 2);
  }
}

// End of a request. A malformed request ends like a wrong command line.
CommandEnd endOf(const Home& home, KeptBench& bench, const std::string& line) {
  try {
    return runCommand(home, bench, wordsOf(line), requireServed);
  } catch (const Error& error) {
    return {error.exitCode(), error.what(), false};
  }
}

// JSON that the command printed, or its text.
Json resultOf(const std::string& output) {
  Json json = Json::parse(output, nullptr, false);
  return json.is_discarded() ? Json(output) : json;
}

void serve(const Home& home, KeptBench& bench) {
  CaughtOutput output;
  std::string line;
  while (std::getline(std::cin, line)) {
    const CommandEnd end = endOf(home, bench, line);
    if (end.is_fault) throw Error(end.error);
    Json answer = {{"exit", end.exit_code}, {"result", resultOf(output.take())}};
    if (!end.error.empty()) answer["error"] = end.error;
    if (!output.answer(answer.dump(-1, ' ', false, Json::error_handler_t::replace))) return;
  }
}

}  // namespace

void registerServe(CLI::App& program, const Home& home, KeptBench& bench) {
  CLI::App* command = program.add_subcommand("serve", "Run the commands of standard input, and keep device and scenes");
  command->footer(
      "A request is one line of JSON with the words of a command line:\n"
      "  {\"command\": [\"render\", \"PIPELINE\", \"--size\", \"320x180\", \"--json\"]}\n"
      "The answer is one line of JSON: \"exit\", the exit code; \"result\", the output of the command, JSON or text;\n"
      "\"error\", the message of a failure. Warnings go to standard error. The program ends with its standard input.\n"
      "A lost device ends it early, with the message on standard error.");
  command->callback([&home, &bench] { serve(home, bench); });
}

}  // namespace strobe::app
