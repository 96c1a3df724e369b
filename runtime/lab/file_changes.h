// SPDX-License-Identifier: MIT
// The files that something running was made of: which of them changed, and what their scripts give now.
#pragma once

#include <future>

#include "base/stamps.h"
#include "base/watch.h"
#include "lab/drawing.h"

namespace strobe::lab {

// Files that differ from what was tried last, and the evaluation with them; where no script is among them, that of what
// runs.
struct FileChanges {
  std::vector<std::string> files;  // as people know them
  bool scripts = false, scene = false;
  double ms = 0;  // hashing the files to see which changed
  Attempt evaluated;
  std::optional<Shot> shot;      // as it was when the evaluation began; empty before that
  double show_failure_at_s = 0;  // of a failure that was held back

  // True if the file may be saved only in part: its failure is younger than a tenth of a second.
  bool mayBeUnfinished() const;
};

class ChangedFiles {
 public:
  explicit ChangedFiles(Workbench& bench) : bench_(bench) {}

  // Notes the state of all files of what runs, so that the next change is seen. Files that are known already stay as
  // they were noted: they may have changed since. Those `tried` last count as they were then. `sound`: what runs is all
  // that was tried; else shaders that it keeps the last good version of are looked at too.
  void remember(const Drawing& running, const std::vector<script::Dependency>& tried, bool sound);

  // What runs, and whether its newest files (its scripts) failed when they were tried last.
  struct Running {
    const Shot& shot;
    const Drawing& drawing;
    bool failed, scripts_failed;
  };
  // Looks for changes. Without `wait`, scripts are evaluated in the background: nothing is returned until a later call
  // finds them done, on the settings as they are then. From the first call on, folders are watched.
  std::optional<FileChanges> look(const Running& running, bool wait);
  // Keeps changes that failed back: a later look returns them again, or with the next changes in their place.
  void holdBack(FileChanges failed);
  // True if scripts are evaluated in the background, or a failure is held back.
  bool evaluates() const { return pending_ || failed_; }

 private:
  // A file or folder.
  struct Noted {
    std::string hash;
    std::optional<Stamps> stamps;  // from before it was read
    double gone_at_s = 0;          // since when it is missed; 0: it is not
  };
  struct Pending {
    FileChanges changes;
    std::future<Attempt> evaluated;  // its destructor waits
  };
  void note(const Path& path, const std::string& hash);
  bool isBeingSaved(Noted& noted, const std::string& now);
  void watchFolders(const Drawing& running);
  FileChanges changedSince(const Drawing& running, bool wait);
  std::optional<FileChanges> evaluatedInBackground(bool wait);
  std::optional<FileChanges> failureAtItsTime(bool wait);
  std::optional<FileChanges> newChanges(const Running& running, bool first, bool wait);

  Workbench& bench_;
  std::map<Path, Noted> noted_;
  std::unique_ptr<Watch> watch_;
  bool watches_all_ = false;  // the folders of all files that are noted
  bool looks_again_ = false;  // even if no event of a folder comes
  std::optional<Pending> pending_;
  std::optional<FileChanges> failed_;
};

}  // namespace strobe::lab
