// SPDX-License-Identifier: MIT
// The files that pictures are made of, by names that mean the same on any machine.
#pragma once

#include <map>
#include <set>

#include "lab/drawing.h"

namespace strobe::archive {

// Names begin with the root that a file lies in: "strobe:" what ships, "project:", "shared:" the shared data,
// "capture:" the folder of the capture script, where that lies in none of these. Any other file has no such name.
struct Input {
  std::string name;
  std::string sha256;
  uint64_t bytes = 0;
  bool operator==(const Input&) const = default;
};
using Inputs = std::map<std::string, Input>;  // by name

Json toJson(const Inputs& inputs);    // [{ name, sha256, bytes }], by name
Inputs inputsFrom(const Json& json);  // throws JSON's exceptions

// A script or a shader, by the ending of its name, or a list of those that are not there (FrozenHome).
bool isText(const Path& file);

class InputNames {
 public:
  // `home`: that files are read from, a copy of `original` or itself. `capture_file`: the script.
  InputNames(const Home& home, const Home& original, const Path& capture_file);
  // Of a home in which files of the folder `other` take the place of its own (FrozenHome): those have the names that
  // the names given have for the folder's.
  InputNames(const Home& home, const InputNames& names, const Path& other);

  // Throws `Error` naming a file that lies in no root; with `allow_outside` it is "outside:" and its absolute path.
  std::string nameOf(const Path& file, bool allow_outside) const;
  // Where a name lies here.
  Path pathOf(const std::string& name) const;

 private:
  struct Root {
    std::string prefix;
    Path folder;
  };
  std::optional<std::string> named(const Path& path) const;

  std::vector<Root> roots_;
  Path other_;
  std::string other_name_;
};

// Reads and adds a file whose content had the hash `was` (base/hash.h, hashText) when it was used; throws `Error` where
// it changed since. Of a folder, of which names were looked at, its scripts.
void addInput(Inputs& inputs, const InputNames& names, const Path& file, const std::string& was,
              bool allow_outside = false);

// What a drawing was made of: scripts, shaders with what they include, the scene's files.
void addInputs(Inputs& inputs, const InputNames& names, const Home& home, const lab::Drawing& drawing,
               bool allow_outside);

}  // namespace strobe::archive
