// SPDX-License-Identifier: MIT
// The command `strobe help`.
#include <gtest/gtest.h>

#include "common/home.h"
#include "lab/reference.h"
#include "program/run.h"

namespace strobe::testing {
namespace help_test {

TEST(Help, ListsTopicsAndPrintsPages) {
  Outcome topics = run("help");
  EXPECT_EQ(topics.exit_code, 0) << topics.err;
  for (const char* topic : {"\n  hybrid ", "\npasses/edge\n", "\n  edge/sobel "})
    EXPECT_NE(topics.out.find(topic), std::string::npos) << topic;
  Outcome page = run("help edge/sobel");
  EXPECT_EQ(page.out.rfind("# edge/sobel\n\n", 0), 0u) << page.out;
  EXPECT_EQ(run("help edge/sobel").out, page.out);
  EXPECT_EQ(run("help sobel").out, page.out);
  EXPECT_NE(page.out.find("| `depth_threshold` | float |"), std::string::npos);
  Outcome param = run("help hybrid.edge");
  EXPECT_EQ(param.out.rfind("# hybrid.edge\n\n", 0), 0u) << param.out;
  EXPECT_EQ(param.out.find("mask_taps"), std::string::npos) << "other parameters are left out";
  Outcome bare = run("help limit");
  for (const char* heading : {"# hybrid.limit\n", "# mcguire2012.limit\n"})
    EXPECT_NE(bare.out.find(heading), std::string::npos)
        << "a parameter without an owner: every pipeline with this parameter";
}

// A call without a command is valid: it lists the commands for new users.
TEST(Help, NoCommandListsTheCommands) {
  Outcome outcome = run("");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, run("--help").out);
  for (const char* command : {"\n  demo ", "\n  render ", "\n  live "})
    EXPECT_NE(outcome.out.find(command), std::string::npos) << outcome.out;
  Outcome misspelt = run("bench relaod");
  EXPECT_EQ(misspelt.exit_code, 2);
  EXPECT_NE(misspelt.err.find("did you mean 'reload'?"), std::string::npos) << misspelt.err;
}

TEST(Help, UnknownTopicsAreRefusedWithTheNearest) {
  for (auto [topic, nearest] : {std::pair("edge/sobl", "edge/sobel"),
                                {"hybrd", "hybrid"},
                                {"hybrid.terminaton", "hybrid.termination"},
                                {"edge/sobel.nrm", "edge/sobel.norm"}}) {
    Outcome outcome = run(std::string("help ") + topic);
    EXPECT_EQ(outcome.exit_code, 2) << topic;
    std::string expected = fmt::format("strobe: unknown help topic '{}'; did you mean '{}'?\n", topic, nearest);
    EXPECT_EQ(outcome.err, expected);
    EXPECT_EQ(outcome.out, "");
  }
  EXPECT_NE(run("help zzzzzzzz").err.find("strobe help lists the topics"), std::string::npos);
}

// Pages of removed passes are deleted; pages written by users stay.
TEST(Help, WritesEveryPage) {
  TemporaryFolder folder;
  ASSERT_EQ(run("help --write " + (folder / "pages")).exit_code, 0);
  for (const lab::ReferencePage& page : lab::referencePages(home()))
    EXPECT_EQ(contentOf(folder.path() / "pages" / page.path), page.text) << page.path;
  fs::path old = folder.path() / "pages/passes/edge/old.md", own = folder.path() / "pages/passes/edge/own.md";
  fs::copy(folder.path() / "pages/passes/edge/sobel.md", old);
  writeText(own, "# own\n");
  ASSERT_EQ(run("help --write " + (folder / "pages")).exit_code, 0);
  EXPECT_FALSE(fs::exists(old));
  EXPECT_TRUE(fs::exists(own));
}

}  // namespace help_test
}  // namespace strobe::testing
