// SPDX-License-Identifier: MIT
// Every Lua file passes luacheck with the settings of .luacheckrc.
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/process.h"
#include "common/source.h"

namespace strobe::repo {
namespace luacheck_test {

std::string outputOf(const std::string& line) {
  return run({.arguments = {"sh", "-c", line}, .errors = Program::Errors::with_output}).output;
}

// Runs luacheck in the project's top folder, where .luacheckrc names files.
std::string complaints(const std::string& paths) {
  return outputOf(fmt::format("cd '{}' && luacheck --no-color --formatter plain {}", sourceFolder().string(), paths));
}

TEST(Luacheck, EveryLuaFilePasses) {
  if (outputOf("luacheck --version").find("Luacheck:") == std::string::npos)
    GTEST_SKIP() << "no luacheck (the package lua-check of Debian)";
  EXPECT_EQ(complaints("passes scripts experiments tests tools"), "");
  std::string wrong = ::testing::TempDir() + "wrong.lua";
  writeFileAtomically(wrong, "local unused = os.time()\n");
  std::string found = complaints(fmt::format("--config .luacheckrc '{}'", wrong));
  EXPECT_NE(found.find("undefined variable 'os'"), std::string::npos) << found;
  EXPECT_NE(found.find("unused variable 'unused'"), std::string::npos) << found;
}

}  // namespace luacheck_test
}  // namespace strobe::repo
