// SPDX-License-Identifier: MIT
// Runs the program as a user does: exit code, standard output and error.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "base/process.h"

namespace strobe::testing {

namespace fs = std::filesystem;

struct Outcome {
  int exit_code = -1;  // 128 + signal for a crash
  std::string out, err;
};

// A folder of its own, removed with everything in it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (fs::temp_directory_path() / "strobe_test_XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  fs::path path() const { return path_; }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

inline std::string contentOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

inline void writeText(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

inline std::string programPath() {
  const char* program = std::getenv("STROBE_PROGRAM");
  return program ? program : "strobe";
}

// A line of the shell.
inline Outcome runLine(const std::string& line, const std::vector<std::string>& environment = {}) {
  ProgramEnd end = strobe::run({.arguments = {"sh", "-c", line}, .environment = environment, .wall_s = 600});
  return {end.code(), end.output, end.errors};
}

// `arguments` as a shell reads them; `environment` like "NAME=value NAME2=value2". Validation is on unless it says not.
inline Outcome run(const std::string& arguments, const std::string& environment = "STROBE_VALIDATION=1") {
  return runLine("exec env " + environment + " '" + programPath() + "' " + arguments);
}

}  // namespace strobe::testing
