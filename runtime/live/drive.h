// SPDX-License-Identifier: MIT
// Drive files: commands to the window, one per line. For tests and for screenshots of the window.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/error.h"

namespace strobe::live {

// Name, arguments and description of a command. The guide, the parser and the window use the same table.
struct CommandForm {
  const char* name;
  const char* arguments;  // "NAME VALUE"; "[X]" is optional
  const char* doc;
};
const std::vector<CommandForm>& commandForms();

// One parsed line of a drive file, the script that controls the window: name, arguments and place in the file.
struct Command {
  std::string name;
  std::vector<std::string> arguments;
  Place place;
};

// Words are separated by spaces. Double quotes join words. '#' outside of quotes begins a comment. Throws `Error` with
// all mistakes and their lines. The message for an unknown command has the nearest known command.
std::vector<Command> parseDrive(const std::string& text, const std::string& file);

// Argument of a command as a number. Both functions throw `Error` at the command's place if the text is not such a
// number.
double numberOf(const Command& command, size_t argument);
int integerOf(const Command& command, size_t argument);

// Executes a command. Returns false if it must be called again after the next frame. Throws `Error` on failure.
using Handler = std::function<bool(const Command&)>;

// Executes commands in order. A command may wait.
class Drive {
 public:
  // `handlers`: exactly one for each command form.
  Drive(std::vector<Command> commands, std::map<std::string, Handler> handlers);
  // Executes commands until one has to wait. Throws `Error` at the place of the failed command.
  void advance();
  bool done() const { return next_ == commands_.size(); }

 private:
  std::vector<Command> commands_;
  std::map<std::string, Handler> handlers_;
  size_t next_ = 0;
};

}  // namespace strobe::live
