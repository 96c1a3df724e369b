// SPDX-License-Identifier: MIT
// A capture from its script to a folder: pictures, figures, films, manifest.json, ro-crate-metadata.json, inputs,
// SHA256SUMS, timings.json.
#pragma once

#include "archive/manifest.h"

namespace strobe::archive {

struct Order {
  std::string file;              // the capture script
  Path folder;                   // where everything is written
  std::string only;              // "", or the beginning of names of pictures
  std::array<int, 2> size = {};  // pixels; {0, 0}: the script's
  bool bundle = false;           // every file that was used goes into FOLDER/inputs, not texts alone
  std::string device;            // index or part of the name of a Vulkan device
  bool validation = false;
};

struct Captured {
  Manifest manifest;
  std::vector<Path> files;  // written for people: figures, films, pictures
};

// What was taken by an earlier call with the same inputs stays; a file that is there under its final name is whole.
// Inputs are frozen at the start: what is edited meanwhile does not count. `report` gets a line for each picture.
// Throws `Error`.
Captured runCapture(const Home& home, const Order& order, const std::function<void(const std::string&)>& report = {});

// Folder of the copies of inputs, and the roots in it ("inputs/strobe/passes/x.lua").
inline constexpr const char* kInputsFolder = "inputs";
Path inputCopy(const std::string& name);

}  // namespace strobe::archive
