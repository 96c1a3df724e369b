// SPDX-License-Identifier: MIT
// Where Strobe's own files and those of a project are found: a value, made once by main() (or a test) and passed on.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"

namespace strobe {

// Files are named as they lie in the shipped folder: "passes/mask/moving.lua", "scripts/pipelines/none.lua". A root
// with a file kProjectFile is a project, which has "pipelines/x.lua" for "scripts/pipelines/x.lua". A project's file
// under a shipped name is an `Error` that names both, unless it says "replaces = true"; so is a file that a link leads
// to from a root to a place outside of it.
class Home {
 public:
  static constexpr const char* kProjectFile = "strobe.project.lua";

  // `roots`: the shipped folder is the last. `data` is the folder of shared data; without it, `shared` beside that one.
  explicit Home(const std::vector<Path>& roots, std::optional<Path> data = {}, Path program = ownProgram());
  explicit Home(const Path& shipped) : Home(std::vector<Path>{shipped}) {}

  // The project that the current folder lies in, if any; STROBE_HOME, else what is shipped with this program;
  // STROBE_DATA; STROBE_PROGRAM.
  static Home fromEnvironment();
  // PREFIX/share/strobe of a program that is PREFIX/bin/strobe. Where that has no scripts: the source tree this program
  // was built from, if there is one.
  static Path shippedWith(const Path& program);

  // Absolute folders; the shipped one is the last.
  const std::vector<Path>& roots() const { return roots_; }
  const Path& shipped() const { return roots_.back(); }
  // Shared test data, where there is such a folder.
  std::optional<Path> data() const;
  // What is started to evaluate a script.
  const Path& program() const { return program_; }

  // The file or folder of this name in the first root that has it.
  std::optional<Path> find(const Path& name) const;
  // The same; where no root has it, the place it would have in the shipped folder.
  Path at(const Path& name) const;
  // The places that a folder of this name has in the roots, whether it is there or not.
  std::vector<Path> places(const Path& name) const;
  // Those that are there.
  std::vector<Path> folders(const Path& name) const;
  // Names of the files with this extension in a folder of any root, without it, sorted.
  std::vector<std::string> namesIn(const Path& folder, std::string_view extension) const;
  // The same of all folders below ("bar", "oracles/bar").
  std::vector<std::string> namesBelow(const Path& folder, std::string_view extension) const;

  // An absolute path that lies in a root, relative to that.
  std::optional<std::string> nameOf(const Path& file) const;
  // `file` relative to the root it lies in (links followed), else unchanged: what errors and records show.
  std::string shown(const Path& file) const;
  // The file's text; errors name it as `shown` does.
  std::string read(const Path& file) const;

 private:
  static Path ownProgram();
  std::optional<Path> placeIn(size_t root, const Path& name) const;
  void requireInside(const Path& file) const;
  std::vector<std::string> joined(const Path& folder, std::string_view extension,
                                  const std::vector<std::vector<std::string>>& lists) const;

  std::vector<Path> roots_;
  std::vector<Path> real_roots_;  // links followed
  std::vector<bool> is_project_;
  std::optional<Path> data_;
  Path program_;
};

// Does `file` lie in `folder`, links followed?
bool liesIn(const Path& file, const Path& folder);

}  // namespace strobe
