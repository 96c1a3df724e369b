// SPDX-License-Identifier: MIT
#include "live/drive.h"

#include <cmath>
#include <sstream>

namespace strobe::live {

const std::vector<CommandForm>& commandForms() {
  static const std::vector<CommandForm> forms = {
      {"set", "NAME VALUE", "set the control NAME, like --set or an option of the shot"},
      {"unset", "NAME", "reset the control NAME to the value of the preset or the scene, or to the default"},
      {"pipeline", "NAME", "run another pipeline"},
      {"replace", "FILE BY", "overwrite FILE with the text of BY, like a save in an editor"},
      {"reloaded", "", "wait until edited files are loaded or refused, 20 s at most"},
      {"wait", "N", "wait for N frames of the window"},
      {"frame", "N", "go to frame N"},
      {"play", "on|off", "start or stop playback; each drawn frame raises the frame number by one"},
      {"orbit", "DX DY", "turn the camera about the point in the middle, as a drag by DX, DY window pixels does"},
      {"view", "PORT", "show an output or NODE.PORT"},
      {"kind", "NAME", "show the image as colour, depth, ...; auto chooses the kind by its format and name"},
      {"mode", "MODE", "display A and B in the mode MODE: single, wipe, flicker, difference or error"},
      {"wipe", "AT", "move the line of the wipe to AT of the width, 0 to 1"},
      {"zoom", "Z X Y", "magnify the fitted picture Z times with pixel (X, Y) in the middle"},
      {"point", "[X] [Y]", "move the pointer to a pixel, or away from the picture"},
      {"inspect", "X Y", "pin a pixel, so that the surfaces along its ray stay listed"},
      {"key", "KEY", "press a key, spelled as in the help"},
      {"sweep", "AXIS [AXIS]", "sweep a control, or two; an axis is NAME or NAME=VALUE,VALUE,..."},
      {"swept", "", "wait until the sweep has all pictures, errors and times, 60 s at most"},
      {"experiment", "FILE.lua", "save the sweep as an experiment"},
      {"click", "X Y", "click the left button at a pixel of the window"},
      {"search", "[TEXT]", "show only controls with TEXT in name or description"},
      {"panels", "on|off", "show or hide everything but the picture"},
      {"help", "on|off", "show or hide the keys"},
      {"resize", "WxH", "resize the window"},
      {"screenshot", "FILE.png", "write a screenshot of the window"},
      {"capture", "FILE.exr", "write the picture like 'strobe render'"},
      {"record", "", "start a recording"},
      {"recording", "FILE.lua", "write the recording as a capture script"},
      {"trail", "FILE.json", "write the trail of the pinned pixel"},
      {"truth", "N", "wait until ground truth in the background has N samples, 60 s at most"},
      {"expect", "NAME VALUE", "fail unless the control has this value"},
      {"problems", "yes|no", "yes: fail if no problem is shown; no: fail if a problem is shown"},
      {"quit", "", "close the window"},
  };
  return forms;
}

namespace {

bool tooManyOrFew(const CommandForm& form, size_t count) {
  std::istringstream words(form.arguments);
  size_t least = 0, most = 0;
  for (std::string word; words >> word; ++most) least += word[0] != '[';
  return count < least || count > most;
}

// Words of a line. Sets `problem` if the line is malformed.
std::vector<std::string> wordsOf(const std::string& line, std::string& problem) {
  std::vector<std::string> words;
  size_t at = 0;
  while (true) {
    at = line.find_first_not_of(" \t\r", at);
    if (at == std::string::npos || line[at] == '#') return words;
    bool quoted = line[at] == '"';
    size_t end = quoted ? line.find('"', at + 1) : line.find_first_of(" \t\r#", at);
    if (quoted && end == std::string::npos) {
      problem = "a quotation mark is not closed";
      return words;
    }
    size_t begin = at + quoted;
    words.push_back(line.substr(begin, end == std::string::npos ? end : end - begin));
    at = end == std::string::npos ? line.size() : end + quoted;
  }
}

std::string mistakeIn(const std::vector<std::string>& words) {
  std::vector<std::string> names;
  for (const CommandForm& form : commandForms()) {
    names.push_back(form.name);
    if (words[0] != form.name) continue;
    if (!tooManyOrFew(form, words.size() - 1)) return "";
    return fmt::format("'{}' takes {}, got {} argument{}", form.name, *form.arguments ? form.arguments : "nothing",
                       words.size() - 1, words.size() == 2 ? "" : "s");
  }
  return fmt::format("unknown command '{}'{}", words[0], didYouMean(words[0], names));
}

}  // namespace

std::vector<Command> parseDrive(const std::string& text, const std::string& file) {
  std::vector<Command> commands;
  std::vector<std::string> problems;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::string problem;
    std::vector<std::string> words = wordsOf(line, problem);
    if (problem.empty() && words.empty()) continue;
    if (problem.empty()) problem = mistakeIn(words);
    Place place{file, number};
    if (!problem.empty()) problems.push_back(fmt::format("{}: {}", place.text(), problem));
    else commands.push_back({words[0], {words.begin() + 1, words.end()}, place});
  }
  throwIfAny(problems);
  return commands;
}

double numberOf(const Command& command, size_t argument) {
  const std::string& text = command.arguments.at(argument);
  std::istringstream stream(text);
  double value = 0;
  if (!(stream >> value) || !stream.eof() || !std::isfinite(value))
    throw Error(fmt::format("'{}': '{}' is not a number", command.name, text), command.place);
  return value;
}

int integerOf(const Command& command, size_t argument) {
  double value = numberOf(command, argument);
  if (value != std::floor(value) || std::abs(value) > 1e9)
    throw Error(fmt::format("'{}': '{}' is not a whole number", command.name, command.arguments[argument]),
                command.place);
  return int(value);
}

Drive::Drive(std::vector<Command> commands, std::map<std::string, Handler> handlers)
    : commands_(std::move(commands)), handlers_(std::move(handlers)) {
  for (const CommandForm& form : commandForms())
    STROBE_ASSERT(handlers_.count(form.name), "no handler of {}", form.name);
  STROBE_ASSERT(handlers_.size() == commandForms().size(), "{} handlers", handlers_.size());
}

void Drive::advance() {
  while (!done()) {
    const Command& command = commands_[next_];
    try {
      if (!handlers_.at(command.name)(command)) return;
    } catch (const Error& error) {
      bool placed = error.place().file == command.place.file && error.place().line == command.place.line;
      if (placed) throw;
      throw Error(fmt::format("'{}' failed: {}", command.name, error.what()), command.place);
    }
    ++next_;
  }
}

}  // namespace strobe::live
