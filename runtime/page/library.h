// SPDX-License-Identifier: MIT
// Chart library of interactive pages: Debian's package node-d3, read from its installed files.
#pragma once

#include <string>

namespace strobe::page {

// Source code of the JavaScript chart library D3, with its name and licence; empty if it is not installed.
struct Library {
  std::string code;     // "": not installed
  std::string name;     // from the first line: "d3 v5.16.0 Copyright 2022 Mike Bostock"
  std::string licence;  // text of the licence; "": the package's copyright file is missing

  bool found() const { return !code.empty(); }
};

inline constexpr const char* kLibraryPackage = "node-d3";

Library findLibrary();

}  // namespace strobe::page
