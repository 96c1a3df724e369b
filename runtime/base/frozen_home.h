// SPDX-License-Identifier: MIT
// Fixed copy of the files that pictures are made of. Later edits of the originals do not count, and edits of copied
// texts do not change the originals.
#pragma once

#include "base/home.h"

namespace strobe {

// A copy of the Lua and GLSL files of a home, removed by the destructor. Models and pictures beside scenes and captures
// are linked, not copied. Files outside of the home's roots are not copied. Scripts that are named by their path in the
// home are read from the copy too (`copyOf`).
class FrozenHome {
 public:
  static constexpr const char* kAbsent = "absent.txt";
  // Folders of a root that are copied.
  static constexpr const char* kParts[] = {"passes", "shaders",  "scripts",    "pipelines",
                                           "scenes", "captures", "experiments"};

  // Copies into `folder`, in place of its content. Files in `other`/strobe and `other`/project, named as in the roots,
  // replace the home's files. `other`/absent.txt lists files to omit, one per line ("strobe/passes/x.lua"). Throws
  // `WriteError` with the system's reason, and `Error` for a name outside of the roots; both leave nothing behind.
  FrozenHome(const Home& home, const Path& folder, const Path& other = {});
  FrozenHome(const FrozenHome&) = delete;
  ~FrozenHome();

  const Home& home() const { return home_; }
  // Path of the copy if `file` lies in a root and was copied, otherwise `file`; also `file` if there is an `other`.
  std::string at(const std::string& file) const;

 private:
  Path folder_;
  Home home_;
};

}  // namespace strobe
