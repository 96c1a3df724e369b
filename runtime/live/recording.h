// SPDX-License-Identifier: MIT
// What is done in the window, as a capture script (docs/captures.md): every state that was drawn becomes a shot and an
// arm, those that were saved become its figure.
#pragma once

#include <memory>

#include "base/frozen_home.h"
#include "base/watch.h"
#include "live/desk.h"
#include "live/moments.h"

namespace strobe::live {

class Recording {
 public:
  // Keeps scripts and shaders as they are, and as they become, in `folder` until it ends. `home` must outlive it.
  Recording(const Home& home, const Path& folder);
  Recording(const Recording&) = delete;
  ~Recording();

  // Before the desk looks at its files in a turn: notes whether any file of the home changed.
  void lookAtFiles() { changed_ = watch_.changed() || changed_; }
  // Takes in what the desk has drawn, once per turn. `goes_on`: a button is down, or it plays.
  void look(const Desk& desk, bool goes_on);
  void markSaved(const Desk& desk);
  size_t moments() const { return moments_.all().size(); }

  // Writes the script (.lua) and, where files were edited meanwhile, their versions into a folder beside it with the
  // script's name without ending; a version from before a file was made says so (FrozenHome). Throws `Error` for
  // another ending and where nothing was drawn; `WriteError`.
  void write(const Path& script, const script::Limits& limits) const;

 private:
  size_t version(const Desk& desk);  // of the files, as they are now
  bool isNew() const;

  const Home& home_;
  Path folder_;
  std::vector<std::unique_ptr<FrozenHome>> versions_;
  int swaps_ = -1;
  Watch watch_;
  bool changed_ = false;  // a file changed since the last version, used by the picture or not
  Moments moments_;
};

// Opens a file in a program of its own, which is not waited for: STROBE_EDITOR, a name and arguments between spaces,
// else what the desktop has for it; nothing where there is neither.
void openInEditor(const Path& file);

}  // namespace strobe::live
