// SPDX-License-Identifier: MIT
// Detection of changes in the files of a running session, and evaluation of the changed scripts.
#pragma once

#include <future>

#include "base/stamps.h"
#include "base/watch.h"
#include "lab/drawing.h"

namespace strobe::lab {

// Files that changed since the last attempt, and the evaluation of their scripts. If no script changed, it is the
// evaluation of the running version.
struct FileChanges {
  std::vector<std::string> files;  // file names for display
  bool scripts = false, scene = false;
  Attempt evaluated;
  std::optional<Shot> shot;      // shot at the start of the evaluation; empty before the evaluation
  double show_failure_at_s = 0;  // time to show a held failure

  // True if the file may be only partly saved: the failure is less than 0.1 s old.
  bool mayBeUnfinished() const;
};

// Watch on the scripts, shaders and scene files of a running session. Evaluates edited scripts, in the background if
// requested, and delays a failure briefly in case a file is only partly saved.
class ChangedFiles {
 public:
  explicit ChangedFiles(Workbench& bench) : bench_(bench) {}

  // Records the state of all files of the running version, so that the next change is detected. Files that are already
  // recorded keep their state, because they may have changed since. `tried`: files of the last attempt, recorded with
  // their state at that time. `sound`: the running version is the last version tried. If false, shaders that run in an
  // older version are watched too.
  void remember(const Drawing& running, const std::vector<script::Dependency>& tried, bool sound);

  // The running version. `failed`: the last attempt failed; `scripts_failed`: it failed in its scripts.
  struct Running {
    const Shot& shot;
    const Drawing& drawing;
    bool failed, scripts_failed;
  };
  // Checks for changes. Without `wait`, scripts are evaluated in the background, and a later call returns the result
  // for the settings at that time. Folders are watched from the first call on.
  std::optional<FileChanges> look(const Running& running, bool wait);
  // Holds failed changes back. A later `look` returns them again, or merges them into newer changes.
  void holdBack(FileChanges failed);
  // True if an evaluation runs in the background or a failure is held back.
  bool evaluates() const { return pending_ || failed_; }

 private:
  // State of a file or folder.
  struct Noted {
    std::string hash;
    std::optional<Stamps> stamps;  // stamps taken before reading
    double gone_at_s = 0;          // time when it disappeared, seconds; 0: present
  };
  struct Pending {
    FileChanges changes;
    std::future<Attempt> evaluated;  // the destructor waits for the evaluation
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
  std::unique_ptr<FileWatch> watch_;
  bool watches_all_ = false;  // true if the folders of all recorded files are watched
  bool looks_again_ = false;  // check files even without a folder event
  std::optional<Pending> pending_;
  std::optional<FileChanges> failed_;
};

}  // namespace strobe::lab
