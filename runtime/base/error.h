// SPDX-License-Identifier: MIT
// Errors in user input (a Lua file, a shader, a scene, the command line), and failures of the machine.
#pragma once

#include <fmt/format.h>

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace strobe {

// Position in a file. `line` and `column` count from 1; 0 means unknown. An empty file means no place.
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
  bool operator==(const Place&) const = default;

  // "file:line:column", without unknown parts.
  std::string text() const;
};

// A user's mistake or a failure of the machine. `what()` is "place: message" on one line. `main` catches the error,
// prints it, and exits with `exit_code` (1, or 2 for a wrong command line).
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

// Throws one `Error` with all messages, joined with newlines, if `messages` is not empty.
void throwIfAny(const std::vector<std::string>& messages, int exit_code = 1);

// The candidate closest to `name` by edit distance, or "" if the distance is too large for a misspelling.
std::string nearestName(std::string_view name, const std::vector<std::string>& candidates);

// "; did you mean 'x'?", or "" if no candidate is near.
std::string didYouMean(std::string_view name, const std::vector<std::string>& candidates);

[[noreturn]] void assertFailed(const char* expression, const char* file, int line, const std::string& detail);

}  // namespace strobe

// Checks for bugs of Strobe. Always compiled. A failure stops the program with the expression and the values given
// after it.
#define STROBE_ASSERT(condition, ...)                                                                      \
  do {                                                                                                     \
    if (!(condition)) ::strobe::assertFailed(#condition, __FILE__, __LINE__, fmt::format("" __VA_ARGS__)); \
  } while (false)
