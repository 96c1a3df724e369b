// SPDX-License-Identifier: MIT
// What the commands of a drive file do in the window, and what they wait for.
#pragma once

#include "live/drive.h"
#include "live/panels.h"
#include "live/picture_view.h"
#include "live/sweeper.h"
#include "live/window.h"

namespace strobe::live {

// What commands work on; it must outlive them.
struct DrivenParts {
  Desk& desk;
  Sweeper& sweeper;
  PanelState& state;
  Window& window;
  std::optional<Path>& screenshot;  // to be written of the next frame of the window, which resets it
  bool& quit;
  std::function<void(Action)> press;
  std::function<void()> begin_recording;
  std::function<void(const Path& script)> stop_recording;
};

class DrivenWindow {
 public:
  // Throws `Error` with every mistake of the file.
  DrivenWindow(const Path& file, const DrivenParts& parts);
  DrivenWindow(const DrivenWindow&) = delete;

  // Carries out commands until one wants to wait, once per turn. Throws `Error` at the place of one that failed.
  void advance() { drive_.advance(); }
  bool done() const { return drive_.done(); }
  // A driven window does not depend on where the mouse happens to be.
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
  // What commands wait for.
  std::optional<int> wait_from_;
  std::optional<double> wait_since_s_;
  int reloads_seen_ = 0;
  bool shot_asked_ = false;
  std::optional<dvec2> pointed_;  // pixel of the picture
  std::optional<dvec2> clicked_;  // of the window
  bool pressed_ = false;          // ... and the button is down
};

}  // namespace strobe::live
