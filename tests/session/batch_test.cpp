// SPDX-License-Identifier: MIT
// A batch draws the same pictures as single calls, and does nothing twice.
#include "lab/batch.h"

#include "common/refusal.h"
#include "lab/record.h"
#include "math/statistics.h"
#include "session/home.h"

namespace strobe::session {
namespace batch_test {

namespace fs = std::filesystem;
using lab::Batch;
using lab::Shot;

std::map<std::string, std::string> outputHashes(const lab::Picture& picture) {
  std::map<std::string, std::string> hashes;
  for (const auto& [name, image] : picture.frame.outputs) hashes[name] = lab::hashOf(image);
  return hashes;
}

class BatchTest : public SessionTest {
 protected:
  // Shot `i` of three pipelines in turn, with its own exposure and its own number of samples or value of a node.
  static Shot point(int i) {
    Shot shot = smallShot(std::vector<std::string>{"hybrid", "mcguire2012", "none"}[size_t(i % 3)]);
    shot.exposure = 0.1 + 0.005 * i;
    if (i % 3 == 0) shot.sets.push_back({"depth_extent", 0.01 + 0.001 * i});
    if (i % 3 == 1) shot.sets.push_back({"samples", 3 + i});
    if (i % 3 == 1) shot.sets.push_back({"limit", 0.01 + 0.001 * i});
    return shot;
  }
  static constexpr int kPoints = 100;
};

TEST_F(BatchTest, AHundredPointsRunNoScriptAndReadNoShader) {
  Batch batch(bench());
  int evaluations = bench().evaluations();
  for (int i = 0; i < 3; ++i) batch.picture(point(i));
  EXPECT_EQ(bench().evaluations() - evaluations, 3) << "one for each pipeline";
  evaluations = bench().evaluations();
  int compilations = bench().compilations();

  // Without these folders no script can be run and no shader read.
  std::map<std::string, std::string> files = home_.all();
  for (const char* folder : {"passes", "shaders", "scripts"})
    fs::rename(home_.path(folder), home_.path(folder + std::string("_away")));
  std::map<int, std::shared_ptr<const lab::Picture>> pictures;
  for (int i = 3; i < kPoints; ++i) pictures[i] = batch.picture(point(i));
  for (const char* folder : {"passes", "shaders", "scripts"})
    fs::rename(home_.path(folder + std::string("_away")), home_.path(folder));
  EXPECT_EQ(bench().evaluations(), evaluations);
  EXPECT_EQ(bench().compilations(), compilations);
  EXPECT_EQ(batch.drawn(), kPoints);

  for (int i : {3, 52, 98}) {
    lab::Picture alone = lab::Workbench(EditableHome::home(), "", true).render(point(i));
    EXPECT_EQ(outputHashes(*pictures.at(i)), outputHashes(alone)) << i;
    for (const char* part : {"shot", "pipeline", "scene", "scripts", "shaders", "outputs"})
      EXPECT_EQ(pictures.at(i)->record[part], alone.record[part]) << i << " " << part;
  }
}

// Also without a batch, as long as no file changes.
TEST_F(BatchTest, PicturesInALoopRunNoScriptTwice) {
  Shot shot = smallShot("hybrid");
  lab::Picture first = bench().render(shot);
  ::usleep(100000);  // younger files are checked again
  bench().render(shot);
  int evaluations = bench().evaluations(), compilations = bench().compilations();
  for (int i = 0; i < 3; ++i) EXPECT_EQ(outputHashes(bench().render(shot)), outputHashes(first));
  EXPECT_EQ(bench().evaluations(), evaluations);
  EXPECT_EQ(bench().compilations(), compilations);
  home_.edit("scripts/scenes/oracles/textured_bar.lua", "\n", "\n\n");
  home_.edit("shaders/shared/frame.h", "\n", "\n\n");
  bench().render(shot);
  EXPECT_EQ(bench().evaluations(), evaluations) << "the pipeline's scripts did not change";
  home_.edit("scripts/pipelines/hybrid.lua", "\n", "\n\n");
  lab::Picture edited = bench().render(shot);
  EXPECT_EQ(bench().evaluations(), evaluations + 1);
  EXPECT_NE(edited.record["scripts"], first.record["scripts"]);
  EXPECT_EQ(edited.record["outputs"], first.record["outputs"]);
}

TEST_F(BatchTest, TheSamePictureIsDrawnOnce) {
  Batch batch(bench());
  Shot shot = smallShot("mcguire2012");
  auto first = batch.picture(shot);
  Shot typed = shot;
  typed.fps = 24;
  EXPECT_EQ(batch.picture(typed), first) << "an explicit value equals the scene's default";
  EXPECT_EQ(batch.drawn(), 1);
  auto color = batch.color(shot);
  EXPECT_EQ(color->values, first->frame.outputs.at("color").floats.values);
  Shot other = shot;
  other.view = {5, 3, 60, 5, 3, 0};
  EXPECT_NE(batch.color(other)->values, color->values);
  EXPECT_NE(batch.picture(other), first);
}

TEST_F(BatchTest, OnlyWantedOutputsAreReadBack) {
  Batch batch(bench());
  auto picture = batch.picture(smallShot("hybrid"), {"color"});
  EXPECT_EQ(picture->frame.outputs.size(), 1u);
  EXPECT_GT(batch.picture(smallShot("hybrid"))->frame.outputs.size(), 1u);
}

TEST_F(BatchTest, RefusalsDifferFromErrors) {
  Batch batch(bench());
  Shot shot = smallShot("mcguire2012");
  shot.sets.push_back({"samples", 0});
  EXPECT_THROW(batch.picture(shot), lab::Refusal);
  const std::string refusal = testing::refusalOf([&] { batch.evaluate("mcguire2012", {{"sampels", 3}}); });
  EXPECT_NE(refusal.find("did you mean 'samples'?"), std::string::npos);
  EXPECT_FALSE(batch.accepts("mcguire2012", {{"sampels", 3}}));
  Shot missing = smallShot("mcguire2012");
  missing.scene = "nowhere";
  try {
    batch.picture(missing);
    ADD_FAILURE();
  } catch (const lab::Refusal&) {
    ADD_FAILURE() << "the pipeline cannot refuse a missing scene";
  } catch (const Error&) {
  }
}

TEST_F(BatchTest, FramesAreTimedInTurn) {
  Batch batch(bench());
  Shot few = smallShot("mcguire2012"), many = few;
  few.sets.push_back({"samples", 2});
  many.sets.push_back({"samples", 1000});
  std::vector<lab::Timing> times = batch.timeInTurn({few, many}, {5, 5});
  ASSERT_EQ(times.size(), 2u);
  for (const lab::Timing& time : times) {
    EXPECT_EQ(time.ms.size(), 5u);
    EXPECT_GT(quantile(time.ms, 0), 0);
  }
  EXPECT_LT(quantile(times[0].ms, 0.25), quantile(times[1].ms, 0.25)) << "a busy machine slows single frames of both";
}

}  // namespace batch_test
}  // namespace strobe::session
