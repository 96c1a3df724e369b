// SPDX-License-Identifier: MIT
// The files that pictures are made of, as they were at one moment: what is edited afterwards does not count, and what
// is edited in the copy changes nothing else.
#pragma once

#include "base/home.h"

namespace strobe {

// A copy of the Lua and GLSL files of a home, removed at the end. Models and pictures beside scenes and captures are
// linked, not copied. What lies outside of the home's roots is left where it is.
class FrozenHome {
 public:
  static constexpr const char* kAbsent = "absent.txt";
  // Folders of a root that are copied.
  static constexpr const char* kParts[] = {"passes", "shaders",  "scripts",    "pipelines",
                                           "scenes", "captures", "experiments"};

  // The copy is made in `folder`, in place of what is there. Files in `other`/strobe and `other`/project, named as in
  // those roots, take the place of the home's own; what `other`/absent.txt names, "strobe/passes/x.lua", one a line, is
  // left out. Throws `WriteError` with the system's reason, and `Error` for a name that leads out; leaves nothing then.
  // Throws `Error` (exit code 2) where another process holds a copy in this folder.
  FrozenHome(const Home& home, const Path& folder, const Path& other = {});
  FrozenHome(const FrozenHome&) = delete;
  ~FrozenHome();

  const Home& home() const { return home_; }
  // Where a file of the home's roots is now; others as they are.
  std::string at(const std::string& file) const;

 private:
  const Home original_;
  Path folder_;
  Home home_;
  int lock_ = -1;
};

}  // namespace strobe
