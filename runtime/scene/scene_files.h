// SPDX-License-Identifier: MIT
// Files that the description of a scene names: images and glTF files.
#pragma once

#include "scene/fields.h"

namespace strobe::scene {

// Folders of the files that a scene names. Names are relative to `folder`. Files must be in `root`, links followed,
// unless `allow_outside`.
struct FilePlaces {
  Path folder;
  Path root = {};  // empty: `folder`
  bool allow_outside = false;
};

// Finder and loader of the images and models named in a scene description, with a list of all files read. Files outside
// of the permitted folder are rejected.
class SceneFiles {
 public:
  explicit SceneFiles(const FilePlaces& places) : places_(places) {}

  bool allowOutside() const { return places_.allow_outside; }
  // Absolute path of the file `name`. Nothing, with a mistake in `fields`, if it does not exist or may not be read.
  std::optional<Path> find(const std::string& name, SceneFields& fields) const;
  // PNG or JPEG `name` as level 0 of a texture. Nothing, with a mistake in `fields`, if it cannot be read.
  std::optional<Texture> image(const std::string& name, SceneFields& fields);
  void add(const SourceFile& file);
  // Files that were read, without duplicates.
  const std::vector<SourceFile>& read() const { return read_; }

 private:
  FilePlaces places_;
  std::vector<SourceFile> read_;
};

}  // namespace strobe::scene
