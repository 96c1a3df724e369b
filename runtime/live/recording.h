// SPDX-License-Identifier: MIT
// Recording of the work in the window as a capture script (docs/captures.md). Each drawn state becomes a shot and an
// arm. Saved states become the figure of the script.
#pragma once

#include <memory>

#include "base/frozen_home.h"
#include "base/watch.h"
#include "live/desk.h"
#include "live/moments.h"

namespace strobe::live {

// Recorder of the states drawn in the window and of the edited versions of their files. Writes them as a capture script
// that reproduces the pictures.
class Recording {
 public:
  // Copies scripts and shaders, and every edited version, into `folder`. The destructor deletes the copies. `home` must
  // outlive the recording.
  Recording(const Home& home, const Path& folder);
  Recording(const Recording&) = delete;
  ~Recording();

  // Records whether a file of the home changed. Call before the desk reloads files in a turn.
  void lookAtFiles() { changed_ = watch_.changed() || changed_; }
  // Records the displayed state of the desk; call once per turn. `goes_on`: a mouse button is down, or frames are
  // played.
  void look(const Desk& desk, bool goes_on);
  void markSaved(const Desk& desk);
  size_t moments() const { return moments_.all().size(); }

  // Writes the script (.lua). If files were edited, also writes the edited files of each version into a folder beside
  // the script, named as the script without its ending. If a version lacks a file that another version has, it lists
  // the file as absent (FrozenHome). Throws `Error` for another ending or if nothing was drawn; `WriteError`.
  void write(const Path& script, const script::Limits& limits) const;

 private:
  size_t version(const Desk& desk);  // number of the current version of the files
  bool isNew() const;

  const Home& home_;
  Path folder_;
  std::vector<std::unique_ptr<FrozenHome>> versions_;
  int swaps_ = -1;
  FileWatch watch_;
  bool changed_ = false;  // a file changed since the last version, whether the picture uses it or not
  Moments moments_;
};

// Opens a file in another program without waiting for the program. STROBE_EDITOR has the program and its arguments,
// separated by spaces; the default is xdg-open. Does nothing if the program is missing.
void openInEditor(const Path& file);

}  // namespace strobe::live
