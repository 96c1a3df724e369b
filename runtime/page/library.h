// SPDX-License-Identifier: MIT
// The chart library of pages to click through: Debian's package node-d3, read where it is installed.
#pragma once

#include <string>

namespace strobe::page {

struct Library {
  std::string code;     // "": it is not installed
  std::string name;     // and copyright, as its first line says: "d3 v5.16.0 Copyright 2022 Mike Bostock"
  std::string licence;  // conditions under which it may be passed on; "": the package's file is not here

  bool found() const { return !code.empty(); }
};

inline constexpr const char* kLibraryPackage = "node-d3";

Library findLibrary();

}  // namespace strobe::page
