// SPDX-License-Identifier: MIT
// A server process with loaded files gives the same results as a process that reads all files itself.
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>

#include "home.h"
#include "plan/description.h"
#include "script/evaluate.h"

namespace strobe::script {
namespace server_test {

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

class Server : public ::testing::Test {
 protected:
  void SetUp() override {
    home_.write("scripts/pipelines/sample.lua", kPipeline);
    evaluatePipeline(home_.home(), {"sample", {}}, &files_);
  }

  // Lets the server load the current files. A file that changes again within the same clock tick would be read again
  // anyway.
  void load() {
    settle();
    failure();
    settle();
  }

  static void settle() { std::this_thread::sleep_for(std::chrono::milliseconds(250)); }

  plan::PipelineDesc evaluate(const Texts& texts = {}) {
    return evaluatePipeline(home_.home(), {"sample", {}, texts}, &files_);
  }

  // True if the documentation of a pass contains the text.
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

TEST_F(Server, GivesEqualResults) {
  const plan::PipelineDesc plain = evaluate({{"/nowhere.lua", ""}});
  const std::vector<Dependency> read = files_;
  load();
  EXPECT_EQ(evaluate(), plain);
  ASSERT_EQ(files_.size(), read.size());
  for (size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(files_[i].path, read[i].path);
    EXPECT_EQ(files_[i].shown, read[i].shown);
    EXPECT_EQ(files_[i].hash, read[i].hash);
  }
}

TEST_F(Server, ChangedFilesAreReadAgain) {
  const std::string before = hashOf("passes/smear.lua");
  load();
  home_.write("passes/smear.lua", smearWith("another text"));
  EXPECT_TRUE(says(evaluate(), "another text"));
  EXPECT_NE(hashOf("passes/smear.lua"), before);
}

TEST_F(Server, TextsReplaceFiles) {
  load();
  const Path file = home_.folder() / "passes/smear.lua";
  EXPECT_TRUE(says(evaluate({{file, smearWith("given")}}), "given"));
  load();
  home_.write("passes/smear.lua", "return nonsense");
  EXPECT_TRUE(says(evaluate({{file, samplePasses().at("passes/smear.lua")}}), "average"));
}

TEST_F(Server, BrokenFilesAreReportedOnRequest) {
  home_.write("passes/smear.lua", "return {");
  load();
  EXPECT_EQ(failure().substr(0, 19), "passes/smear.lua:1:");
  load();
  home_.write("passes/smear.lua", smearWith("mended"));
  EXPECT_TRUE(says(evaluate(), "mended"));
  load();
  std::filesystem::remove(home_.folder() / "passes/smear.lua");
  EXPECT_NE(failure().find("unknown module 'passes.smear'"), std::string::npos);
}

TEST_F(Server, ProjectFileReplacesAShippedFile) {
  TestHome project;
  const Home both({project.folder(), home_.folder()}, {}, home_.home().program());
  std::vector<Dependency> files;
  auto evaluated = [&] { return evaluatePipeline(both, {"sample", {}}, &files); };
  for (const auto& [path, text] : samplePasses()) std::filesystem::remove(project.folder() / path);
  EXPECT_FALSE(says(evaluated(), "the project's"));
  settle();
  EXPECT_FALSE(says(evaluated(), "the project's"));
  settle();
  project.write("passes/smear.lua", "-- replaces = true\n" + smearWith("the project's"));
  EXPECT_TRUE(says(evaluated(), "the project's"));
}

// Children of this process, found by the parent process number in /proc.
static std::vector<pid_t> children() {
  std::vector<pid_t> found;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string name = entry.path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    std::ifstream file(entry.path() / "stat");
    std::string text((std::istreambuf_iterator<char>(file)), {});
    const size_t end = text.rfind(')');
    if (end != std::string::npos && std::atoi(text.c_str() + end + 4) == ::getpid()) found.push_back(std::stoi(name));
  }
  return found;
}

TEST_F(Server, IsReplacedIfItEnds) {
  const plan::PipelineDesc plain = evaluate();
  ASSERT_FALSE(children().empty());
  for (pid_t child : children()) ::kill(child, SIGKILL);
  EXPECT_EQ(evaluate(), plain);
}

TEST_F(Server, IsSharedByThreads) {
  const plan::PipelineDesc plain = evaluate();
  const std::vector<pid_t> before = children();
  std::vector<std::jthread> threads;
  for (int i = 0; i < 16; ++i)
    threads.emplace_back([&] { EXPECT_EQ(evaluatePipeline(home_.home(), {"sample", {}}), plain); });
  threads.clear();
  EXPECT_EQ(children(), before);
}

}  // namespace server_test
}  // namespace strobe::script
