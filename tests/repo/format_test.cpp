// SPDX-License-Identifier: MIT
// Every C++ file is formatted by clang-format 14; other versions break lines differently.
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/files.h"
#include "base/process.h"
#include "common/home.h"

namespace strobe::repo {
namespace format_test {

// Output and errors of a shell command.
std::string shell(const std::string& line) {
  return run({.arguments = {"sh", "-c", line}, .errors = Program::Errors::with_output}).output;
}

// Name of a clang-format of version 14; "" if it is not installed.
std::string clangFormat() {
  for (const char* name : {"clang-format-14", "clang-format"})
    if (shell(std::string(name) + " --version").find("version 14.") != std::string::npos) return name;
  return "";
}

std::string complaints(const std::string& program, const std::string& files) {
  return shell(files + " | xargs -0 " + program + " --style=file:'" + (home().shipped() / ".clang-format").string() +
               "' --dry-run -Werror");
}

TEST(Format, EveryCppFileIsFormatted) {
  std::string program = clangFormat();
  if (program.empty()) GTEST_SKIP() << "no clang-format of version 14 (the package clang-format of Debian 12)";
  std::string top = "'" + home().shipped().string() + "'";
  std::string find = fmt::format("find {0}/runtime {0}/tests -name '*.cpp' -print0 -o -name '*.h' -print0", top);
  EXPECT_EQ(complaints(program, find), "");
  std::string wrong = ::testing::TempDir() + "wrong.cpp";
  writeFileAtomically(wrong, "int  f( ) {return 1;}\n");
  EXPECT_NE(complaints(program, "printf '" + wrong + "\\0'"), "");
}

}  // namespace format_test
}  // namespace strobe::repo
