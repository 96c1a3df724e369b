// SPDX-License-Identifier: MIT
// What is done in the window, as a capture script (docs/captures.md): every state that was drawn becomes a shot and an
// arm, those that were saved become its figure.
#pragma once

#include <memory>

#include "base/frozen_home.h"
#include "live/desk.h"

namespace strobe::live {

// What the window showed at a time: A, and B where it is compared, each as `render` would make it.
struct Moment {
  std::vector<lab::Shot> shots;
  std::vector<std::string> images;   // that were looked at, one per shot; "color" where there is none
  size_t files = 0;                  // which version of scripts and shaders
  int first_frame = 0;               // played from here to the frame of the shots
  std::vector<std::string> changed;  // against the one before: parameters, options, "image", "files", "comparison"
  bool goes_on = false;              // a button is down, or it plays
  bool saved = false;                // as a picture
};

// Moments in their order. A slider that is dragged, a camera that flies and images that are looked through are one
// moment each, with the last value; frames played one after another are one, a sequence.
class Moments {
 public:
  void add(Moment now);  // `changed` and `first_frame` are found here
  void markSaved();      // the last one
  const std::vector<Moment>& all() const { return all_; }

 private:
  std::vector<Moment> all_;
};

class Recording {
 public:
  // Keeps scripts and shaders as they are, and as they become, in `folder` until it ends. `home` must outlive it.
  Recording(const Home& home, const Path& folder);
  Recording(const Recording&) = delete;
  ~Recording();

  // Takes in what the desk has drawn, once per turn. `goes_on`: a button is down, or it plays.
  void look(const Desk& desk, bool goes_on);
  void markSaved(const Desk& desk);
  size_t moments() const { return moments_.all().size(); }

  // Writes the script (.lua) and, where files were edited meanwhile, their versions into a folder beside it with the
  // script's name without ending. Throws `Error` for another ending, where nothing was drawn and where a scene does not
  // load any more; `WriteError`.
  void write(lab::Workbench& bench, const Path& script) const;

 private:
  size_t version(const Desk& desk);  // of the files, as they are now

  const Home& home_;
  Path folder_;
  std::vector<std::unique_ptr<FrozenHome>> versions_;
  int swaps_ = -1;
  Moments moments_;
};

// Opens a file in a program of its own, which is not waited for: STROBE_EDITOR, else what the desktop has for it;
// nothing where there is neither.
void openInEditor(const Path& file);

// The script's text. `suggested`: by scene (`sceneKey`), the options that it suggests. `folders`: of each version of
// the files, the folder of those that differ, "" where none does.
struct Recorded {
  std::vector<Moment> moments;
  std::map<std::string, lab::Shot> suggested;
  std::vector<std::string> folders;
};
std::string sceneKey(const lab::Shot& shot);
std::string captureText(const Recorded& recorded);

}  // namespace strobe::live
