// SPDX-License-Identifier: MIT
// What a child reads before it is asked, and what one does not send again, changes no result.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "home.h"
#include "plan/description.h"
#include "script/evaluate.h"
#include "script/process.h"

namespace strobe::script {
namespace ahead_test {

static const char* kPipeline = R"(local pipeline = require "strobe.pipeline"
local base  = require "passes.base"
local smear = require "passes.smear"
return pipeline {
  doc = "two passes",
  params = { taps = pipeline.int { 8, min = 1, max = 64, doc = "images taken" } },
  build = function(p)
    local seen = base {}
    return { color = smear { color = seen.color, max = seen.velocity, taps = p.taps }.color, depth = seen.depth }
  end,
}
)";

class Ahead : public ::testing::Test {
 protected:
  void SetUp() override {
    home_.write("scripts/pipelines/sample.lua", kPipeline);
    evaluatePipeline(home_.home(), {"sample", {}}, &files_);
  }

  // A child that has read the files as they are now. A change within the same tick of the clock would not be seen as
  // one, in which case it reads them again: nothing to test.
  void expect() {
    settle();
    expectChildren(home_.home(), {}, 1, files_);
    settle();
  }

  static void settle() { std::this_thread::sleep_for(std::chrono::milliseconds(250)); }

  plan::PipelineDesc evaluate(const Texts& texts = {}) {
    return evaluatePipeline(home_.home(), {"sample", {}, texts}, &files_);
  }

  // True if the documentation of a pass has the text.
  static bool says(const plan::PipelineDesc& pipeline, const std::string& text) {
    return std::any_of(pipeline.passes.begin(), pipeline.passes.end(),
                       [&](const plan::PassDesc& pass) { return pass.doc.find(text) != std::string::npos; });
  }

  static std::string smearWith(const std::string& doc) {
    std::string text = samplePasses().at("passes/smear.lua");
    const std::string before = "average along the velocity";
    return text.replace(text.find(before), before.size(), doc);
  }

  std::string failure() {
    try {
      evaluate();
    } catch (const Error& error) {
      return error.what();
    }
    return "none";
  }

  std::string hashOf(const std::string& shown) const {
    for (const Dependency& file : files_)
      if (file.shown == shown) return file.hash;
    return "";
  }

  TestHome home_;
  std::vector<Dependency> files_;
};

TEST_F(Ahead, ChangesNoResult) {
  const plan::PipelineDesc plain = evaluate();
  const std::vector<Dependency> read = files_;
  expect();
  EXPECT_EQ(evaluate(), plain);
  ASSERT_EQ(files_.size(), read.size());
  for (size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(files_[i].path, read[i].path);
    EXPECT_EQ(files_[i].shown, read[i].shown);
    EXPECT_EQ(files_[i].hash, read[i].hash);
  }
}

TEST_F(Ahead, WhatChangesMeanwhileIsReadAgain) {
  const std::string before = hashOf("passes/smear.lua");
  expect();
  home_.write("passes/smear.lua", smearWith("another text"));
  EXPECT_TRUE(says(evaluate(), "another text"));
  EXPECT_NE(hashOf("passes/smear.lua"), before);
}

TEST_F(Ahead, TextsStandInThePlaceOfFiles) {
  expect();
  const Path file = home_.folder() / "passes/smear.lua";
  EXPECT_TRUE(says(evaluate({{file, smearWith("given")}}), "given"));
  expect();
  home_.write("passes/smear.lua", "return nonsense");
  EXPECT_TRUE(says(evaluate({{file, samplePasses().at("passes/smear.lua")}}), "average"));
}

TEST_F(Ahead, WhatIsBrokenIsReportedWhenItIsAskedFor) {
  home_.write("passes/smear.lua", "return {");
  expect();
  EXPECT_EQ(failure().substr(0, 19), "passes/smear.lua:1:");
  expect();
  home_.write("passes/smear.lua", smearWith("mended"));
  EXPECT_TRUE(says(evaluate(), "mended"));
  expect();
  std::filesystem::remove(home_.folder() / "passes/smear.lua");
  EXPECT_NE(failure().find("unknown module 'passes.smear'"), std::string::npos);
}

TEST_F(Ahead, AProjectsFileTakesThePlaceOfAShippedOne) {
  TestHome project;
  const Home both({project.folder(), home_.folder()}, {}, home_.home().program());
  std::vector<Dependency> files;
  auto evaluated = [&] { return evaluatePipeline(both, {"sample", {}}, &files); };
  for (const auto& [path, text] : samplePasses()) std::filesystem::remove(project.folder() / path);
  EXPECT_FALSE(says(evaluated(), "the project's"));
  settle();
  expectChildren(both, {}, 1, files);
  settle();
  project.write("passes/smear.lua", "-- replaces = true\n" + smearWith("the project's"));
  EXPECT_TRUE(says(evaluated(), "the project's"));
}

// ---- what is not sent again

TEST_F(Ahead, WhatWasDescribedBeforeIsNamed) {
  std::shared_ptr<const Described> described;
  auto again = [&] { return evaluatePipeline(home_.home(), {"sample", {}}, nullptr, {}, nullptr, &described); };
  const plan::PipelineDesc first = evaluate();
  EXPECT_EQ(again(), first);
  ASSERT_TRUE(described);
  EXPECT_EQ(described->pass_hashes.size(), 2u);
  EXPECT_EQ(again(), first);

  const std::vector<std::string> hashes = described->pass_hashes;
  home_.write("passes/smear.lua", smearWith("another text"));
  EXPECT_EQ(again(), evaluate());
  ASSERT_EQ(described->pass_hashes.size(), 2u);
  EXPECT_EQ((described->pass_hashes[0] == hashes[0]) + (described->pass_hashes[1] == hashes[1]), 1);

  const std::string params = described->params_hash;
  std::string pipeline = kPipeline;
  home_.write("scripts/pipelines/sample.lua", pipeline.replace(pipeline.find("max = 64"), 8, "max = 32"));
  EXPECT_EQ(again(), evaluate());
  EXPECT_NE(described->params_hash, params);
}

TEST_F(Ahead, AFailureKeepsWhatWasDescribed) {
  std::shared_ptr<const Described> described;
  evaluatePipeline(home_.home(), {"sample", {}}, nullptr, {}, nullptr, &described);
  const std::shared_ptr<const Described> before = described;
  home_.write("passes/smear.lua", "return {");
  EXPECT_THROW(evaluatePipeline(home_.home(), {"sample", {}}, nullptr, {}, nullptr, &described), Error);
  EXPECT_EQ(described, before);
}

}  // namespace ahead_test
}  // namespace strobe::script
