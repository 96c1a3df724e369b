// SPDX-License-Identifier: MIT
// Files of shaders, and what their includes mean, each looked at once: for a time in which no edit is to be seen.
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "base/home.h"

namespace strobe::shader {

// From any thread.
class Sources {
 public:
  // `home` must outlive it.
  explicit Sources(const Home& home) : home_(home) {}

  // The text of a file, which stays where it is. Throws `Error` as Home::read does.
  const std::string& read(const Path& file);
  // What an include of `name` in the file `from` means: a file beside that one, else one in the shaders folders of the
  // home; empty if it is in neither. A file outside of the home (a test's) includes what lies in its own folder.
  Path included(const std::string& name, const Path& from);

 private:
  Path look(const std::string& name, const Path& folder) const;

  const Home& home_;
  std::mutex mutex_;
  std::map<Path, std::string> texts_;
  std::map<std::pair<std::string, Path>, Path> includes_;  // by name and folder
};

}  // namespace strobe::shader
