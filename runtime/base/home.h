// SPDX-License-Identifier: MIT
// Where Strobe's own files and those of a project are found: a value, made once by main() (or a test) and passed on.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"

namespace strobe {

// Files are named as they lie in the shipped folder: "passes/mask/moving.lua", "scripts/pipelines/none.lua".
class Home {
 public:
  // `roots`: the shipped folder is the last. `data` is the folder of shared data; without it, `shared` beside that one.
  explicit Home(const std::vector<Path>& roots, std::optional<Path> data = {}, Path program = ownProgram());
  explicit Home(const Path& shipped) : Home(std::vector<Path>{shipped}) {}

  // STROBE_HOME, else the source tree the program was built from; STROBE_DATA; STROBE_PROGRAM.
  static Home fromEnvironment();

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
  // The folders of this name in all roots.
  std::vector<Path> folders(const Path& name) const;
  // Names of the files with this extension in a folder of any root, without it, sorted.
  std::vector<std::string> namesIn(const Path& folder, std::string_view extension) const;
  // The same of all folders below ("bar", "oracles/bar").
  std::vector<std::string> namesBelow(const Path& folder, std::string_view extension) const;

  // The name of an absolute path that lies in a root.
  std::optional<std::string> nameOf(const Path& file) const;
  // `file` relative to the root it lies in (links followed), else unchanged: what errors and records show.
  std::string shown(const Path& file) const;
  // The file's text; errors name it as `shown` does.
  std::string read(const Path& file) const;

 private:
  static Path ownProgram();

  std::vector<Path> roots_;
  std::optional<Path> data_;
  Path program_;
};

}  // namespace strobe
