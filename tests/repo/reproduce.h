// SPDX-License-Identifier: MIT
// Runs tools/reproduce as a user does.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/process.h"
#include "common/source.h"

namespace strobe::repo {

struct Outcome {
  int code = -1;
  std::string text;  // output and errors
};

inline Outcome reproduce(const std::vector<std::string>& arguments, const std::vector<std::string>& environment = {}) {
  std::vector<std::string> all = {"python3", "-B", (sourceFolder() / "tools/reproduce").string()};
  all.insert(all.end(), arguments.begin(), arguments.end());
  ProgramEnd end = run({.arguments = all, .environment = environment, .errors = Program::Errors::with_output});
  return {end.code(), end.output};
}

// Skipped without Python.
class ReproduceTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (run({.arguments = {"sh", "-c", "command -v python3"}}).code() != 0) GTEST_SKIP() << "no python3";
  }
};

}  // namespace strobe::repo
