// SPDX-License-Identifier: MIT
// Where Strobe's own files and those of a project are found: a value, made once by main() (or a test) and passed on.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"

namespace strobe {

// Files are named as they lie in the shipped folder: "passes/mask/moving.lua", "scripts/pipelines/none.lua". Before it
// may stand the folder of a project, which has "pipelines/x.lua" for "scripts/pipelines/x.lua". A project's file under
// a shipped name is an `Error`, unless one of the comment lines that it begins with is "replaces = true"; so is one
// that says so and replaces nothing, and one that a link leads to out of the roots.
class Home {
 public:
  static constexpr const char* kProjectFile = "strobe.project.lua";

  static constexpr const char* kOwnProgram = "/proc/self/exe";

  // In front of names of files, where it matters in which root they lie.
  static constexpr const char *kProjectPrefix = "project:", *kShippedPrefix = "strobe:", *kSharedPrefix = "shared:";

  // `roots`: the project's folder, if any, and the shipped one. `data` is the folder of shared data; without it,
  // `shared` beside that one. `cache` is a folder for what can be made again; empty: none.
  explicit Home(const std::vector<Path>& roots, std::optional<Path> data = {}, Path program = kOwnProgram,
                Path cache = {});
  // Other roots and other shared data, the rest as there.
  Home(const Home& other, const std::vector<Path>& roots, std::optional<Path> data)
      : Home(roots, std::move(data), other.program(), other.cache()) {}
  explicit Home(const Path& shipped) : Home(std::vector<Path>{shipped}) {}

  // The project that the current folder lies in, if any; STROBE_HOME, else what is shipped with this program;
  // STROBE_DATA; STROBE_PROGRAM; STROBE_CACHE, else XDG_CACHE_HOME/strobe, else ~/.cache/strobe.
  static Home fromEnvironment();
  // PREFIX/share/strobe of a program that is PREFIX/bin/strobe. Where that has no scripts: the source tree this program
  // was built from, if there is one.
  static Path shippedWith(const Path& program);

  // Absolute folders; the shipped one is the last.
  const std::vector<Path>& roots() const { return roots_; }
  const Path& shipped() const { return roots_.back(); }
  bool hasProject() const { return roots_.size() > 1; }
  const Path& project() const { return roots_.front(); }
  // Shared test data, where there is such a folder.
  std::optional<Path> data() const;
  // What is started to evaluate a script.
  const Path& program() const { return program_; }
  const Path& cache() const { return cache_; }

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

  // Of all files of the project: those that `find` refuses. There is a project.
  std::vector<std::string> mistakesOfProject() const;

  // An absolute path that lies in a root, relative to that.
  std::optional<std::string> nameOf(const Path& file) const;
  // That with the root in front, "project:passes/x.lua" or "strobe:passes/x.lua", as records have it; of shared data
  // "shared:scenes/x.glb"; `outside` for any other file (links followed).
  std::string recorded(const Path& file, const std::string& outside) const;
  // As errors have it: the same without the prefix of the first root; `file` as it is where it lies in none.
  std::string shown(const Path& file) const;
  // The file that `shown` gave this name.
  Path fileShown(const std::string& name) const;
  // What `shown` gave, without a root in front.
  static std::string withoutRoot(const std::string& name);
  // The file's text; errors name it as `shown` does.
  std::string read(const Path& file) const;

 private:
  static std::optional<size_t> rootOf(const Path& file, const std::vector<Path>& roots);
  std::optional<std::string> named(const Path& file, std::optional<size_t> bare) const;
  void requireInside(const Path& file) const;
  void requireDeclared(const Path& own, const Path& shipped) const;
  std::vector<std::string> joined(const Path& folder, std::string_view extension,
                                  const std::vector<std::vector<std::string>>& lists) const;

  std::vector<Path> roots_;
  std::vector<Path> real_roots_;  // links followed
  std::optional<Path> data_;
  Path program_, cache_;
};

// Does `file` lie in `folder`, links followed?
bool liesIn(const Path& file, const Path& folder);

}  // namespace strobe
