// SPDX-License-Identifier: MIT
// Drive files: commands to the window, one per line, for tests and for screenshots of the window. A command may wait
// for a condition.
#pragma once

#include "live/panels.h"
#include "live/picture_view.h"
#include "live/sweeper.h"
#include "live/window.h"

namespace strobe::live {

class DrivenWindow;

// One parsed line of a drive file, the script that controls the window: name, arguments and place in the file.
struct Command {
  std::string name;
  std::vector<std::string> arguments;
  Place place;
};

// Name, arguments, description and action of a command. The guide, the parser and the window use the same table.
struct CommandForm {
  std::string name;
  std::string arguments;  // "NAME VALUE"; "[X]" is optional
  std::string doc;
  // Executes a command. Returns false if it must be called again after the next frame. Throws `Error` on failure.
  bool (*run)(DrivenWindow& window, const Command& command);
};

// Words are separated by spaces. Double quotes join words. '#' outside of quotes begins a comment. Throws `Error` with
// all mistakes and their lines. The message for an unknown command has the nearest known command.
std::vector<Command> parseDrive(const std::string& text, const std::string& file);

// Argument of a command as a number. Both functions throw `Error` at the command's place if the text is not such a
// number.
double numberOf(const Command& command, size_t argument);
int integerOf(const Command& command, size_t argument);

// Parts of the window that commands use. The parts must outlive the DrivenWindow.
struct DrivenParts {
  Desk& desk;
  Sweeper& sweeper;
  PanelState& state;
  Window& window;
  std::optional<Path>& screenshot;  // file for a screenshot of the next window frame; reset when written
  bool& quit;
  std::function<void(Action)> press;
  std::function<void()> begin_recording;
  std::function<void(const Path& script)> stop_recording;
};

// Runs a drive file, the script that controls the window, for tests and screenshots. A command may wait for a condition
// over several frames.
class DrivenWindow {
 public:
  static const std::vector<CommandForm> kForms;  // all commands

  // Throws `Error` with all mistakes of the file.
  DrivenWindow(const Path& file, const DrivenParts& parts);
  DrivenWindow(const DrivenWindow&) = delete;

  // Executes commands until one has to wait; call once per turn. Throws `Error` at the place of the failed command.
  void advance();
  bool done() const { return next_ == commands_.size(); }
  // Sets ImGui's pointer and button from the commands, so that the position of the mouse has no effect.
  void point(const PictureView& view) const;

 private:
  // Start of a command: number of the window frame, and clock.
  struct Start {
    int frame;
    double time_s;
  };
  int framesPassed() const;  // since the start of the command
  double secondsPassed() const;

  DrivenParts parts_;
  std::vector<Command> commands_;
  size_t next_ = 0;
  std::optional<Start> start_;  // of the command that runs
  // State of commands that wait.
  int reloads_seen_ = 0;
  bool shot_asked_ = false;
  std::optional<dvec2> pointed_;  // pixel of the picture
  std::optional<dvec2> clicked_;  // pixel of the window
  bool pressed_ = false;          // the button at `clicked_` is down
};

}  // namespace strobe::live
