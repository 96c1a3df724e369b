// SPDX-License-Identifier: MIT
#include "page/library.h"

#include "base/files.h"

namespace strobe::page {

// The explorer uses only functions common to d3 5, 6 and 7; node-d3 of Debian 12 and 13 is 5.16.
Library findLibrary() {
  Library library;
  for (const char* file : {"/usr/share/nodejs/d3/dist/d3.min.js", "/usr/share/javascript/d3/d3.min.js"}) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) continue;
    std::string code = readText(file), first = code.substr(0, code.find('\n'));
    bool known = first.starts_with("// https://d3js.org v5.") || first.starts_with("// https://d3js.org v6.") ||
                 first.starts_with("// https://d3js.org v7.");
    if (!known) continue;
    library.code = code;
    library.name = "d3 " + first.substr(std::string_view("// https://d3js.org ").size());
    Path licence = std::string("/usr/share/doc/") + kLibraryPackage + "/copyright";
    if (std::filesystem::exists(licence, ignored)) library.licence = readText(licence);
    break;
  }
  return library;
}

}  // namespace strobe::page
