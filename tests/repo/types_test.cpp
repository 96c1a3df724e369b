// SPDX-License-Identifier: MIT
// Every public type has a comment and a unique name, and docs/types.md lists it.
#include <gtest/gtest.h>

#include "base/files.h"
#include "base/process.h"
#include "common/source.h"

namespace strobe::repo {
namespace types_test {

TEST(Types, PageListsEachTypeWithItsSentence) {
  if (run({.arguments = {"sh", "-c", "command -v python3"}}).code() != 0) GTEST_SKIP() << "no python3";
  ProgramEnd end = run({.arguments = {"python3", "-B", (sourceFolder() / "tools/types").string()}});
  EXPECT_EQ(end.code(), 0) << "python3 tools/types names the faults";
  EXPECT_EQ(end.output, readText(sourceFolder() / "docs/types.md")) << "python3 tools/types --write docs/types.md";
}

}  // namespace types_test
}  // namespace strobe::repo
