// SPDX-License-Identifier: MIT
// Files that pictures are made of, with names that mean the same on any machine.
#pragma once

#include <map>
#include <set>

#include "lab/drawing.h"

namespace strobe::archive {

// Input file of a capture, with the hash of its content. A name begins with the root of the file: "strobe:" for shipped
// files, "project:", "shared:" for shared data, or "capture:" for the folder of the capture script, if the file lies in
// no other root. Any other file has no such name.
struct Input {
  std::string name;
  std::string sha256;
  uint64_t bytes = 0;
  std::string hash = {};  // hash when the file was used (base/hash.h, hashText); not in manifests
  bool operator==(const Input&) const = default;
};
using Inputs = std::map<std::string, Input>;  // by name

Json toJson(const Inputs& inputs);    // [{ name, sha256, bytes }], by name
Inputs inputsFrom(const Json& json);  // throws Json::exception

// True for a script or a shader, by extension, and for a list of absent files (FrozenHome).
bool isText(const Path& file);

// Converts between paths of input files and names that are the same on every machine.
class InputNames {
 public:
  // `home`: home of the files, `original` or its copy. `capture_file`: the script.
  InputNames(const Home& home, const Home& original, const Path& capture_file);
  // Names for a home with replacements from the folder `other` (FrozenHome). A replacement has the name that `names`
  // gives to its file in `other`.
  InputNames(const Home& home, const InputNames& names, const Path& other);

  // Throws `Error` naming a file that lies in no root. With `allow_outside`, the name is "outside:" and the absolute
  // path.
  std::string nameOf(const Path& file, bool allow_outside) const;
  // Path of a named file on this machine.
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

// Adds a file. `was`: hash of the file's content when it was used (base/hash.h, hashText). Throws `Error` if the file
// changed since, or between two uses. For a folder that was listed, adds its scripts.
void addInput(Inputs& inputs, const InputNames& names, const Path& file, const std::string& was,
              bool allow_outside = false);

// Adds the inputs of a drawing: scripts, shaders with their includes, the scene's files.
void addInputs(Inputs& inputs, const InputNames& names, const Home& home, const lab::Drawing& drawing,
               bool allow_outside);

}  // namespace strobe::archive
