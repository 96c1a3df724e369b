// SPDX-License-Identifier: MIT
// The simulation of tools/sweep_model.py agrees with the model in docs/labs.md.
#include <gtest/gtest.h>

#include "base/files.h"
#include "base/process.h"
#include "common/source.h"

namespace strobe::repo {
namespace sweep_model_test {

TEST(SweepModel, SimulationAgreesWithTheModel) {
  const std::string tool = (sourceFolder() / "tools/sweep_model.py").string();
  ProgramEnd end = run({.arguments = {"python3", "-B", tool, "--points", "2000", "--workers", "20", "--stagger", "1"}});
  if (end.code() == 127) GTEST_SKIP() << "no python3";
  EXPECT_EQ(end.code(), 0) << end.errors;
  EXPECT_NE(end.output.find("claim: 2.2 ms on paper; after all starts 2.2 ms simulated"), std::string::npos)
      << end.output;
  EXPECT_NE(end.output.find("publish: 4.2 ms on paper; after all starts 4.3 ms simulated"), std::string::npos)
      << end.output;
}

// The page quotes the numbers of the default settings.
TEST(SweepModel, PageHasItsNumbers) {
  const std::string tool = (sourceFolder() / "tools/sweep_model.py").string();
  ProgramEnd end = run({.arguments = {"python3", "-B", tool}});
  if (end.code() == 127) GTEST_SKIP() << "no python3";
  const std::string page = readText(sourceFolder() / "docs/labs.md");
  for (const char* line : {"all starts: 61 s", "within 2.4 ms", "within 5.0 ms", "archives: 1000",
                           "limit of the server: 594 points", "whole sweep: 1062 s on paper, 1169 s simulated"})
    EXPECT_NE(end.output.find(line), std::string::npos) << line << "\n" << end.output;
  for (const char* text : {"61 s of the server", "within 2.4 ms", "within 5.0 ms", "1,000 archives",
                           "594 points per second", "1,062 s | 1,169 s"})
    EXPECT_NE(page.find(text), std::string::npos) << text;
}

}  // namespace sweep_model_test
}  // namespace strobe::repo
