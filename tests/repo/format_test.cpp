// SPDX-License-Identifier: MIT
// Every C++ file is as clang-format 14 writes it; other versions break lines elsewhere.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>

#include "base/error.h"
#include "base/files.h"
#include "common/home.h"

namespace strobe::repo {
namespace format_test {

struct Outcome {
  int code = -1;
  std::string text;  // of both streams
};

Outcome shell(const std::string& command) {
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  Outcome outcome;
  char part[4096];
  while (size_t count = fread(part, 1, sizeof part, pipe)) outcome.text.append(part, count);
  int status = pclose(pipe);
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

// The program of version 14; "" where there is none.
std::string clangFormat() {
  for (const char* name : {"clang-format-14", "clang-format"})
    if (shell(std::string(name) + " --version").text.find("version 14.") != std::string::npos) return name;
  return "";
}

std::string complaints(const std::string& program, const std::string& files) {
  return shell(files + " | xargs -0 " + program + " --style=file:'" + (home().shipped() / ".clang-format").string() +
               "' --dry-run -Werror")
      .text;
}

TEST(Format, EveryCppFileIsAsClangFormatWritesIt) {
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
