// SPDX-License-Identifier: MIT
// Locations of Strobe's own files and of a project's files: a value, created once by main() or by a test, and passed
// on.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"

namespace strobe {

// Folders of the scripts, passes and shaders: a project, if there is one, and the shipped files. Files are named by
// their path in the shipped folder: "passes/mask/moving.lua", "scripts/pipelines/none.lua". The folder of a project may
// precede the shipped folder, and has "pipelines/x.lua" for "scripts/pipelines/x.lua". `find` throws `Error` for a
// project's file with a shipped name, unless "replaces = true" is one of its first comment lines; for a file with this
// line but without a shipped name; and for a link that leads out of the roots.
class Home {
 public:
  static constexpr const char* kProjectFile = "strobe.project.lua";

  static constexpr const char* kOwnProgram = "/proc/self/exe";

  // Prefixes of file names that state the root.
  static constexpr const char *kProjectPrefix = "project:", *kShippedPrefix = "strobe:", *kSharedPrefix = "shared:";

  // `roots`: the project's folder, if any, then the shipped folder. `data`: folder of shared data; default: `shared`
  // beside the shipped folder. `cache`: folder for files that can be made again; empty: no cache.
  explicit Home(const std::vector<Path>& roots, std::optional<Path> data = {}, Path program = kOwnProgram,
                Path cache = {});
  // Other roots and other shared data, program and cache as in `other`.
  Home(const Home& other, const std::vector<Path>& roots, std::optional<Path> data)
      : Home(roots, std::move(data), other.program(), other.cache()) {}
  explicit Home(const Path& shipped) : Home(std::vector<Path>{shipped}) {}

  // From the environment. Roots: the project that contains the current folder, if any, then STROBE_HOME, or
  // shippedWith(this program). Shared data: STROBE_DATA. Program: STROBE_PROGRAM, or this program. Cache: STROBE_CACHE,
  // else XDG_CACHE_HOME/strobe, else ~/.cache/strobe.
  static Home fromEnvironment();
  // PREFIX/share/strobe for the program PREFIX/bin/strobe. If it has no scripts: the source tree of this build, if it
  // exists.
  static Path shippedWith(const Path& program);

  // Roots that the roots are copies of (FrozenHome); empty: this home is not a copy.
  std::vector<Path> originals;

  // Absolute folders; the shipped folder is the last.
  const std::vector<Path>& roots() const { return roots_; }
  const Path& shipped() const { return roots_.back(); }
  bool hasProject() const { return roots_.size() > 1; }
  const Path& project() const { return roots_.front(); }
  // Shared test data, if the folder exists.
  std::optional<Path> data() const;
  // Program that evaluates a script.
  const Path& program() const { return program_; }
  const Path& cache() const { return cache_; }

  // File or folder of this name in the first root that has it.
  std::optional<Path> find(const Path& name) const;
  // Like `find`; if no root has the name, its path in the shipped folder.
  Path at(const Path& name) const;
  // Paths of a folder of this name in the roots, existing or not.
  std::vector<Path> places(const Path& name) const;
  // Existing folders of this name in the roots.
  std::vector<Path> folders(const Path& name) const;
  // Sorted names of the files with this extension in a folder of any root, without the extension.
  std::vector<std::string> namesIn(const Path& folder, std::string_view extension) const;
  // Like `namesIn`, including all folders below ("bar", "oracles/bar").
  std::vector<std::string> namesBelow(const Path& folder, std::string_view extension) const;

  // Messages for the project's scripts and shaders that `find` refuses; empty without a project.
  std::vector<std::string> mistakesOfProject() const;

  // Path relative to the root of the file; nothing if the file lies in no root. `file` is absolute.
  std::optional<std::string> nameOf(const Path& file) const;
  // Name in records: with its root, "project:passes/x.lua" or "strobe:passes/x.lua"; for shared data
  // "shared:scenes/x.glb"; `outside` for any other file. Links are followed.
  std::string recorded(const Path& file, const std::string& outside) const;
  // Name in errors: with its root, except for the first root; `file` itself if it lies in no root.
  std::string shown(const Path& file) const;
  // File of a name that `shown` returned.
  Path fileShown(const std::string& name) const;
  // Name that `shown` returned, without its root.
  static std::string withoutRoot(const std::string& name);
  // Text of the file. Errors name the file as `shown` does.
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

// "/p/shaders or /s/shaders", for messages on missing files.
std::string placesText(const Home& home, const Path& folder);

// Path of the copy of a file, if `home` is a copy of the file's home and has the file; otherwise `file`. `file` is
// absolute.
Path copyOf(const Home& home, const Path& file);

// True if `file` lies in `folder`, with links followed.
bool liesIn(const Path& file, const Path& folder);

}  // namespace strobe
