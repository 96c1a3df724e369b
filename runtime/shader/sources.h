// SPDX-License-Identifier: MIT
// Files of shaders and targets of their includes, each read once, so edits after the first read have no effect.
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "base/home.h"

namespace strobe::shader {

// Texts of shader files with the files that they include. Thread-safe.
class Sources {
 public:
  // `home` must outlive this object.
  explicit Sources(const Home& home) : home_(home) {}

  // The text of a file; the reference stays valid. Throws `Error` as Home::read does.
  const std::string& read(const Path& file);
  // The file that `name` in an include of the file `from` refers to: in the folder of `from`, otherwise in the shaders
  // folders of the home; empty if not found. A file outside of the home (a test's) may include files of its own folder.
  Path included(const std::string& name, const Path& from);

 private:
  Path look(const std::string& name, const Path& folder) const;

  const Home& home_;
  std::mutex mutex_;
  std::map<Path, std::string> texts_;
  std::map<std::pair<std::string, Path>, Path> includes_;  // by name and folder
};

}  // namespace strobe::shader
