// SPDX-License-Identifier: MIT
// The instructions of a documentation page: files to write and commands to run.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/files.h"

namespace strobe::testing {

// Contents of a page's fenced blocks:
//   ```lua passes/x.lua      a file, with the language of its ending
//   ```lua passes/x.lua:12   line 12 of that file with a mistake; the next ```text error has the message
//   ```sh                    commands "./strobe ..." or "strobe ..."; ```sh fails: a command that fails with the next
//   ```text error
struct Page {
  struct Mistake {
    std::string file, line, command, error;  // a file and its line, or a command
    int number = 0;
  };
  std::map<std::string, std::string> files;
  std::vector<Mistake> mistakes;
  std::vector<std::string> commands;  // without "strobe "
};

// `name` below docs/.
Page readPage(const std::string& name);

// `text` with line `number` (from 1) replaced.
std::string withLine(const std::string& text, int number, const std::string& line);

}  // namespace strobe::testing
