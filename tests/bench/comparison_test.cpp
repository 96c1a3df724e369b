// SPDX-License-Identifier: MIT
// Comparisons of two runs with given times find the changed pass and leave out changes of the machine's speed.
#include "bench/comparison.h"

#include <gtest/gtest.h>

#include "bench/report.h"
#include "bench/synthetic.h"

namespace strobe::bench::test {
namespace comparison_test {

constexpr int kRounds = 18;

// Every pass takes 10 ms with noise; factors slow down `gather` and all passes.
bench::Run timed(int seed, double gather = 1, double all = 1, bool software = false, int rounds = kRounds) {
  return runOf(
      rounds,
      [=](const std::string& method, const std::string& pass, int round) {
        int own = int(pass.size() + method.size());
        return 10 * all * (pass == "gather" ? gather : 1) * noise(round, seed + own);
      },
      software);
}

std::vector<std::string> movedIn(const TimeComparison& comparison) {
  std::vector<std::string> names;
  for (const Change& change : comparison.changes)
    if (change.moved) names.push_back(change.shot->method + " " + (change.pass.empty() ? "frame" : change.pass));
  return names;
}

const Change& changeOf(const TimeComparison& comparison, const std::string& method, const std::string& pass) {
  for (const Change& change : comparison.changes)
    if (change.shot->method == method && change.pass == pass) return change;
  throw std::out_of_range(pass);
}

using Names = std::vector<std::string>;

TEST(TimeComparison, FindsTheChangedPass) {
  bench::Run before = timed(1), now = timed(5, 1.3);
  TimeComparison comparison = compared(now, before, 0.05);
  EXPECT_EQ(comparison.kind, TimeComparison::Kind::milliseconds);
  EXPECT_EQ(movedIn(comparison), (Names{"blurred frame", "blurred gather"})) << "a frame of three passes: 10 %";
  EXPECT_NEAR(changeOf(comparison, "blurred", "gather").ratio.value, 1.3, 0.01);
  EXPECT_LE(changeOf(comparison, "blurred", "gather").ratio.low, 1.3);
  EXPECT_GE(changeOf(comparison, "blurred", "gather").ratio.high, 1.3);
  EXPECT_EQ(movedIn(compared(now, before, 0.2)), (Names{"blurred gather"})) << "the frame changed by less than 20 %";
  EXPECT_EQ(movedIn(compared(now, before, 0.4)), Names());
  EXPECT_EQ(movedIn(compared(now, now, 0.01)), Names()) << "against itself";
}

TEST(TimeComparison, TooFewRoundsGiveNoResult) {
  bench::Run before = timed(1, 1, 1, false, 6), now = timed(5, 3, 1, false, 6);
  EXPECT_EQ(movedIn(compared(now, before, 0.05)), Names());
}

// All passes are 1.5 times slower, as on a busy machine: on a software device only the changed pass is reported.
TEST(TimeComparison, DividesByTheBaseOnASoftwareDevice) {
  bench::Run before = timed(1, 1, 1, true), slower = timed(5, 1, 1.5, true), now = timed(5, 1.3, 1.5, true);
  TimeComparison comparison = compared(slower, before, 0.05);
  EXPECT_EQ(comparison.kind, TimeComparison::Kind::base);
  EXPECT_EQ(movedIn(comparison), Names());
  EXPECT_NEAR(changeOf(comparison, "sharp", "").ratio.value, 1.49, 0.02) << "the base is compared in milliseconds";
  EXPECT_EQ(movedIn(compared(now, before, 0.05)), (Names{"blurred frame", "blurred gather"}));
  EXPECT_NEAR(changeOf(compared(now, before, 0.05), "blurred", "gather").ratio.value, 1.3, 0.03);
}

// A faster base makes all other methods look slower relative to it; their milliseconds show that they are unchanged.
TEST(TimeComparison, FasterBaseLeavesOthersUnchanged) {
  auto run = [](double base, int seed) {
    return runOf(
        kRounds,
        [=](const std::string& method, const std::string&, int round) {
          return 10 * (method == "sharp" ? base : 1) * noise(round, seed);
        },
        true);
  };
  const bench::Run before = run(1, 1), now = run(0.7, 3);
  TimeComparison comparison = compared(now, before, 0.05);
  EXPECT_NEAR(changeOf(comparison, "blurred", "gather").ratio.value, 1 / 0.7, 0.05);
  EXPECT_EQ(movedIn(comparison), Names());
}

TEST(TimeComparison, AcrossDevicesIsRelative) {
  bench::Run before = timed(1), now = timed(5);
  before.driver = "an older driver";
  before.environment = {{"LP_NUM_THREADS", "2"}};
  before.frames_in_flight = 2;
  TimeComparison comparison = compared(now, before, 0.05);
  EXPECT_EQ(comparison.kind, TimeComparison::Kind::base);
  EXPECT_EQ(comparison.differ, (Names{"driver an older driver, now a driver", "frames in flight 2, now 1",
                                      "environment LP_NUM_THREADS=2, now nothing"}));
}

// The machine slows down from block to block, alike for both programs: milliseconds are compared within a pair of
// blocks.
TEST(TimeComparison, BlocksAreComparedInPairs) {
  std::vector<bench::Run> now, before;
  for (int block = 0; block < 8; ++block) {
    double machine = 1 + 0.2 * block;
    before.push_back(timed(block, 1, machine, true, 3));
    now.push_back(timed(block + 4, 1.3, machine, true, 3));
  }
  TimeComparison comparison = compared(now, before, 0.05);
  EXPECT_EQ(comparison.kind, TimeComparison::Kind::blocks);
  EXPECT_EQ(comparison.blocks, 8u);
  EXPECT_EQ(movedIn(comparison), (Names{"blurred frame", "blurred gather"}));
  EXPECT_NEAR(changeOf(comparison, "blurred", "gather").ratio.value, 1.3, 0.05);
  EXPECT_NEAR(changeOf(comparison, "blurred", "gather").before_ms, 17, 0.5) << "between the fourth block and the fifth";
  TimeComparison few = compared(std::vector<bench::Run>(now.begin(), now.begin() + 5),
                                std::vector<bench::Run>(before.begin(), before.begin() + 5), 0.05);
  EXPECT_EQ(movedIn(few), Names()) << "five blocks have no interval of 95 %";
}

TEST(TimeComparison, NamesPassesOfOneRunOnly) {
  bench::Run before = timed(1), now = timed(5);
  now.shots[1].passes[2].name = "gather_wide";
  TimeComparison comparison = compared(now, before, 0.05);
  EXPECT_EQ(comparison.gone, (Names{"gather of blurred, room, 64x36"}));
  EXPECT_EQ(comparison.added, (Names{"gather_wide of blurred, room, 64x36"}));
  EXPECT_EQ(comparison.changes.size(), 4u + 4u) << "frame, draw, shade and rest of both";
}

TEST(TimeComparison, IsReportedAsTextAndJson) {
  bench::Run before = timed(1), now = timed(5, 1.3);
  TimeComparison comparison = compared(now, before, 0.05);
  comparison.against = "before.json";
  std::string text = textOf(now, &comparison);
  EXPECT_NE(text.find("Against before.json"), std::string::npos) << text;
  EXPECT_NE(text.find("2 of 9 frames and passes moved."), std::string::npos) << text;
  EXPECT_NE(text.find("slower"), std::string::npos) << text;
  Json json = toJson(comparison);
  EXPECT_EQ(json["moved"], 2);
  EXPECT_EQ(json["changes"].size(), 9u);
  EXPECT_TRUE(json["changes"][0]["pass"].is_null());
  std::string html = page::htmlOf(pageOf(now, &comparison));
  EXPECT_NE(html.find("Against before.json"), std::string::npos);
  EXPECT_NE(html.find("gather"), std::string::npos);
  EXPECT_EQ(page::htmlOf(pageOf(now, nullptr)).find("Against"), std::string::npos);
}

}  // namespace comparison_test
}  // namespace strobe::bench::test
