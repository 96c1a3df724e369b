// SPDX-License-Identifier: MIT
// Actions of the drive file's commands in the window, and the conditions that they wait for.
#pragma once

#include "live/drive.h"
#include "live/panels.h"
#include "live/picture_view.h"
#include "live/sweeper.h"
#include "live/window.h"

namespace strobe::live {

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
  // Throws `Error` with all mistakes of the file.
  DrivenWindow(const Path& file, const DrivenParts& parts);
  DrivenWindow(const DrivenWindow&) = delete;

  // Executes commands until one has to wait; call once per turn. Throws `Error` at the place of the failed command.
  void advance() { drive_.advance(); }
  bool done() const { return drive_.done(); }
  // Sets ImGui's pointer and button from the commands, so that the position of the mouse has no effect.
  void point(const PictureView& view) const;

 private:
  using Handlers = std::map<std::string, Handler>;
  Handlers handlers();
  void addShotHandlers(Handlers& handlers);
  void addLookHandlers(Handlers& handlers);
  void addWaitHandlers(Handlers& handlers);
  void addFileHandlers(Handlers& handlers);
  void addSweepHandlers(Handlers& handlers);
  Handler afterFrames(int frames, std::function<void(const Command&)> then);

  DrivenParts parts_;
  Drive drive_;
  // State of commands that wait.
  std::optional<int> wait_from_;
  std::optional<double> wait_since_s_;
  int reloads_seen_ = 0;
  bool shot_asked_ = false;
  std::optional<dvec2> pointed_;  // pixel of the picture
  std::optional<dvec2> clicked_;  // pixel of the window
  bool pressed_ = false;          // the button at `clicked_` is down
};

}  // namespace strobe::live
