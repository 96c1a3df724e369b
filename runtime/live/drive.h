// SPDX-License-Identifier: MIT
// A window that a file drives: one command a line, as hands would give them. For tests and for pictures of the window.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/error.h"

namespace strobe::live {

// What a command is called and takes; the guide, the parser and the window walk the same table.
struct CommandForm {
  const char* name;
  const char* arguments;  // "NAME VALUE"; "[X]" may be left out, "..." takes the rest of the line as one
  const char* doc;
};
const std::vector<CommandForm>& commandForms();

struct Command {
  std::string name;
  std::vector<std::string> arguments;
  Place place;
};

// Words are separated by spaces; "double quotes" hold one together; '#' outside of them begins a comment. Throws
// `Error` with every mistake of the text, each at its line, unknown commands with the nearest.
std::vector<Command> parseDrive(const std::string& text, const std::string& file);

// A number in an argument; throw `Error` at the command's place.
double numberOf(const Command& command, size_t argument);
int integerOf(const Command& command, size_t argument);

// Carries out a command; false: not yet, ask again after the next frame. Throws `Error` where it fails.
using Handler = std::function<bool(const Command&)>;

// Goes through commands in order, as far as they get.
class Drive {
 public:
  // There must be a handler for each form, and none besides.
  Drive(std::vector<Command> commands, std::map<std::string, Handler> handlers);
  // Carries out commands until one wants to wait. Throws `Error` at the place of the command that failed.
  void advance();
  bool done() const { return next_ == commands_.size(); }

 private:
  std::vector<Command> commands_;
  std::map<std::string, Handler> handlers_;
  size_t next_ = 0;
};

}  // namespace strobe::live
