// SPDX-License-Identifier: MIT
// Failures caused by what a user wrote or requested: a Lua file, a shader, a scene, the command line, the machine.
#pragma once

#include <fmt/format.h>

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace strobe {

// Where something was written. `line` and `column` count from 1; 0 means unknown. An empty file means no place.
struct Place {
  std::string file;
  int line = 0;
  int column = 0;

  // "file:line:column", without the parts that are unknown.
  std::string text() const;
};

// A user's mistake or a refusal of the machine. `what()` is "place: message" on one line.
// Caught at one boundary: `main` prints it and exits with `exit_code` (1, or 2 for a wrong command line).
class Error : public std::runtime_error {
 public:
  explicit Error(std::string message, Place place = {}, int exit_code = 1);
  const Place& place() const { return place_; }
  const std::string& message() const { return message_; }
  int exitCode() const { return exit_code_; }

 private:
  std::string message_;
  Place place_;
  int exit_code_;
};

// Several mistakes found in one validation, joined with newlines; throws if `messages` is not empty.
void throwIfAny(const std::vector<std::string>& messages, int exit_code = 1);

// The candidate closest to `name` by edit distance, or "" when none is near enough to be a misspelling of it.
std::string nearestName(std::string_view name, const std::vector<std::string>& candidates);

// "; did you mean 'x'?" or "" when nothing is near.
std::string didYouMean(std::string_view name, const std::vector<std::string>& candidates);

[[noreturn]] void assertFailed(const char* expression, const char* file, int line, const std::string& detail);

}  // namespace strobe

// Our own mistakes: always compiled, stops the program with the expression and the values given after it.
#define STROBE_ASSERT(condition, ...)                                                                      \
  do {                                                                                                     \
    if (!(condition)) ::strobe::assertFailed(#condition, __FILE__, __LINE__, fmt::format("" __VA_ARGS__)); \
  } while (false)
