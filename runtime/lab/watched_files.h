// SPDX-License-Identifier: MIT
// Files that something running was made of, with what they held when they were last tried.
#pragma once

#include <map>
#include <memory>

#include "base/watch.h"
#include "script/evaluate.h"

namespace strobe::lab {

class WatchedFiles {
 public:
  // As it was when it was tried last; replaces what was noted before.
  void tried(const std::vector<script::Dependency>& files);
  // Files that are known already stay as they were noted: they may have changed since.
  void add(const std::vector<script::Dependency>& files);
  void add(const Path& file);

  // From the first call on, events below `deep` folders and in `flat` ones are seen. True at that call.
  bool watch(const std::vector<Path>& deep);
  void watchFlat(const std::vector<script::Dependency>& files);
  bool isWatching() const { return watch_ != nullptr; }
  // Whether anything happened there since the last call.
  bool event() { return watch_->changed(); }

  // Files that hold something else than was noted; notes what they hold now.
  std::vector<Path> takeChanged();

 private:
  std::map<Path, std::string> noted_;  // hash of every file and folder
  std::unique_ptr<Watch> watch_;
};

}  // namespace strobe::lab
