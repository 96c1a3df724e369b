// SPDX-License-Identifier: MIT
// Evaluations that fork from a process with loaded scripts equal evaluations in a separate process.
#include <thread>

#include "plan/description.h"
#include "session/home.h"

namespace strobe::session {
namespace evaluator_test {

using lab::Evaluation;
using script::Settings;

const char* const kPass = "passes/gather/mcguire2012.lua";

// Description of the pipeline and its files; after a failure, the error.
using Answered = std::pair<plan::PipelineDesc, std::string>;

Answered answeredBy(const Evaluation& evaluation) {
  std::string text;
  for (const script::Dependency& file : evaluation.scripts) text += fmt::format("\n{} {}", file.shown, file.hash);
  return {evaluation.pipeline, text};
}

template <class Evaluate>
Answered answerOf(const Evaluate& evaluate) {
  try {
    return answeredBy(evaluate());
  } catch (const Error& error) {
    return {{}, error.what()};
  }
}

// Evaluates in a process that loads all files itself, as for every request with texts in place of files.
Answered aloneIn(const Home& home, const std::string& pipeline, const Settings& sets, const script::Limits& limits) {
  return answerOf([&] {
    Evaluation evaluation;
    const script::Texts texts = {{"/nowhere.lua", ""}};
    evaluation.pipeline = script::evaluatePipeline(home, {pipeline, sets, texts}, &evaluation.scripts, limits);
    return evaluation;
  });
}

class EvaluatorTest : public SessionTest {
 protected:
  Answered forked(const std::string& pipeline, const Settings& sets) {
    return answerOf([&] { return lab::evaluated(EditableHome::home(), pipeline, sets, limits_); });
  }
  Answered alone(const std::string& pipeline, const Settings& sets) {
    return aloneIn(EditableHome::home(), pipeline, sets, limits_);
  }

  script::Limits limits_;
};

TEST_F(EvaluatorTest, ForksEqualSeparateProcesses) {
  const std::vector<Settings> some = {{},
                                      {{"samples", int64_t{4}}},
                                      {{"samples", std::string("many")}},
                                      {{"nothing", true}},
                                      {{"preset", std::string("text")}}};
  for (int round = 0; round < 2; ++round)
    for (const char* pipeline : {"mcguire2012", "hybrid", "nowhere"})
      for (const Settings& sets : some) EXPECT_EQ(forked(pipeline, sets), alone(pipeline, sets)) << pipeline;
}

TEST_F(EvaluatorTest, ChangedFilesAreLoadedAgain) {
  for (int i = 0; i < 3; ++i) {
    for (int64_t samples : {3, 4, 5})
      EXPECT_EQ(forked("mcguire2012", {{"samples", samples}}), alone("mcguire2012", {{"samples", samples}}));
    const Answered before = forked("mcguire2012", {});
    home_.edit(kPass, "doc    = \"", "doc    = \"edited ", i == 0 ? Save::InPlace : Save::Rename);
    EXPECT_NE(forked("mcguire2012", {}), before);
  }
  home_.write(kPass, "return nil +");
  EXPECT_EQ(forked("mcguire2012", {}), alone("mcguire2012", {}));
}

TEST_F(EvaluatorTest, ServesLongerThanTheTimeLimitOfAScript) {
  limits_.cpu_s = 0.1;
  const Answered once = alone("mcguire2012", {});
  for (int i = 0; i < 400 && !HasFailure(); ++i) EXPECT_EQ(forked("mcguire2012", {}), once) << i;
  // The limit is checked when the kernel's clock ticks, every few milliseconds, so it stops some of many forks.
  limits_.cpu_s = 0.001;
  bool is_stopped = false;
  for (int i = 0; i < 400 && !is_stopped; ++i)
    is_stopped = forked("hybrid", {}).second.find("more than 0.001 s") != std::string::npos;
  EXPECT_TRUE(is_stopped);
  limits_ = {};
  EXPECT_EQ(forked("mcguire2012", {}), once);
}

TEST_F(EvaluatorTest, ReplacingFilesAreLoaded) {
  const Path project = ::testing::TempDir() + "evaluator_project";
  std::filesystem::remove_all(project);
  std::filesystem::create_directories(project);
  writeFileAtomically(project / Home::kProjectFile, std::string_view(""));
  const Home home(EditableHome::home(), {project, EditableHome::home().shipped()}, {});
  auto answer = [&] { return answerOf([&] { return lab::evaluated(home, "mcguire2012", {}, limits_); }); };
  auto expectFresh = [&] { EXPECT_EQ(answer(), aloneIn(home, "mcguire2012", {}, limits_)); };
  for (int i = 0; i < 2; ++i) expectFresh();
  for (const auto& [own, shipped] : {std::pair<std::string, std::string>("passes/gather/mcguire2012.lua", kPass),
                                     {"pipelines/mcguire2012.lua", "scripts/pipelines/mcguire2012.lua"}}) {
    const Answered before = answer();
    std::filesystem::create_directories((project / own).parent_path());
    for (const std::string edit : {"", "-- again\n"}) {
      writeFileAtomically(project / own, "-- replaces = true\n" + edit + home_.read(shipped));
      for (int i = 0; i < 3; ++i) expectFresh();
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      for (int i = 0; i < 3; ++i) expectFresh();
    }
    EXPECT_NE(answer(), before);
  }
  std::filesystem::remove_all(project);
}

// Loaded scripts outlive the thread that loaded them.
TEST_F(EvaluatorTest, OtherThreadsReuseLoadedScripts) {
  const Answered once = forked("mcguire2012", {});
  std::thread([&] { EXPECT_EQ(forked("mcguire2012", {}), once); }).join();
  for (int i = 0; i < 3; ++i) EXPECT_EQ(forked("mcguire2012", {}), once);
}

}  // namespace evaluator_test
}  // namespace strobe::session
