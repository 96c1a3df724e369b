// SPDX-License-Identifier: MIT
// Runs as data: parts add up, ratios to the base, and files that are read back or refused.
#include "bench/times.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "bench/synthetic.h"

namespace strobe::bench::test {
namespace times_test {

double inOrder(const std::string&, const std::string& pass, int round) {
  return (pass == "gather" ? 2 : 1) * (1 + 0.1 * round);
}

std::string refusal(const Json& json) {
  try {
    runFrom(json, "x.json");
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

std::string refusalOf(const Run& run, const Run& other) {
  try {
    requireSameShots(run, other, "x.json");
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Times, PartsAddUpToTheFrame) {
  bench::Run run = runOf(5, inOrder);
  for (const ShotTimes& shot : run.shots) {
    std::vector<PassTimes> parts = shot.parts();
    EXPECT_EQ(parts.size(), shot.passes.size() + 1);
    EXPECT_EQ(parts.back().name, kRest);
    for (size_t round = 0; round < 5; ++round) {
      double sum = 0;
      for (const PassTimes& part : parts) sum += part.ms[round];
      EXPECT_NEAR(sum, shot.ms[round], 1e-12);
      EXPECT_NEAR(parts.back().ms[round], 0.5, 1e-12);
    }
  }
  bench::Run overlapping = runOf(5, inOrder, false, -1);
  EXPECT_EQ(overlapping.shots[0].parts().back().ms[0], 0) << "no time is below 0";
}

TEST(Times, TypicalRoundIsNearestToTheMedian) {
  bench::Run run =
      runOf(3, [](const std::string&, const std::string&, int round) { return round == 1 ? 5 : 9 * round; });
  EXPECT_EQ(run.shots[0].typicalRound(), 1u) << "frames of 0.5, 10.5 and 36.5 ms";
}

// Rounds slow down by a half, but ratios within a round change little: 4.5 / 2.5 in the first round, and a smaller
// share of the constant rest later. The estimate is between the fourth and fifth of eight values; the interval leaves
// out the first and last (scipy.stats.binom(8, 0.5).cdf(0) = 0.004, cdf(1) = 0.035).
TEST(Times, RatiosAreToTheBaseInTheSameRound) {
  bench::Run run = runOf(8, inOrder);
  EXPECT_EQ(ratioToBase(run, run.shots[0]).value, 1);
  Estimate ratio = ratioToBase(run, run.shots[1]);
  auto at = [](double round) { return (0.5 + 4 * (1 + 0.1 * round)) / (0.5 + 2 * (1 + 0.1 * round)); };
  EXPECT_NEAR(ratio.value, (at(3) + at(4)) / 2, 1e-12);
  EXPECT_NEAR(ratio.low, at(0), 1e-12);
  EXPECT_NEAR(ratio.high, at(7), 1e-12);
  ShotTimes elsewhere = run.shots[1];
  elsewhere.width = 128;
  run.shots.push_back(elsewhere);
  EXPECT_EQ(&run.baseOf(run.shots[2]), &run.shots[2]) << "another image size has its own base";
}

TEST(Times, BlocksAreJoinedRoundByRound) {
  bench::Run run = joined({runOf(2, inOrder), runOf(3, inOrder)});
  EXPECT_EQ(run.shots[1].ms.size(), 5u);
  EXPECT_EQ(run.shots[1].passes[2].ms, (std::vector<double>{2, 2.2, 2, 2.2, 2.4}));
}

TEST(Times, AreReadBackUnchanged) {
  bench::Run run = runOf(4, inOrder, true);
  run.environment = {{"LP_NUM_THREADS", "2"}};
  Json json = toJson(run);
  bench::Run again = runFrom(Json::parse(json.dump()), "x.json");
  EXPECT_EQ(toJson(again), json);
  EXPECT_EQ(again.shots[1].passes[2].ms, run.shots[1].passes[2].ms);
  EXPECT_TRUE(again.software);
}

TEST(Times, OtherFilesAreRefused) {
  EXPECT_EQ(refusal(Json::parse("{", nullptr, false)),
            "x.json: is not a run of `strobe bench frames` (--save, --json)");
  EXPECT_EQ(refusal(Json::parse("[1]")), refusal(Json::object()));
  Json json = toJson(runOf(2, inOrder));
  json["strobe_bench"] = 2;
  EXPECT_EQ(refusal(json), "x.json: is a run of format 2; this program reads format 1");
  const std::string damaged = "x.json: is a damaged run of `strobe bench frames`";
  json = toJson(runOf(2, inOrder));
  json["shots"][0].erase("ms");
  EXPECT_EQ(refusal(json), damaged);
  json = toJson(runOf(2, inOrder));
  json["shots"][1]["passes"][0]["ms"].push_back(1);
  EXPECT_EQ(refusal(json), damaged) << "a pass of more rounds than its frame";
  json["shots"] = Json::array();
  EXPECT_EQ(refusal(json), damaged);
}

TEST(Times, RunsOfOtherShotsAreRefused) {
  const bench::Run run = runOf(2, inOrder);
  EXPECT_EQ(refusalOf(run, runOf(9, inOrder, true)), "accepted") << "times and device do not matter";
  bench::Run other = run;
  other.shots[1].method = "other";
  EXPECT_EQ(refusalOf(run, other),
            "x.json: a run of other shots cannot be compared: it has no 'blurred, room, 64x36'; it also has "
            "'other, room, 64x36'");
  other = run;
  std::swap(other.shots[0], other.shots[1]);
  EXPECT_NE(refusalOf(run, other).find("in another order"), std::string::npos);
  other = run;
  other.shots[1].shot["exposure"] = 0.25;
  EXPECT_NE(refusalOf(run, other).find("'blurred, room, 64x36' has other options: exposure 0.25"), std::string::npos);
  other = run;
  other.shots[1].shot["aa"] = 1;
  EXPECT_EQ(refusalOf(run, other), "accepted") << "an option that one revision lacks has its default";
  EXPECT_EQ(refusalOf(other, run), "accepted");
  other.shots[1].shot["aa"] = 4;
  EXPECT_NE(refusalOf(run, other).find("has other options: aa 4"), std::string::npos);
  EXPECT_NE(refusalOf(other, run).find("has other options: aa 1"), std::string::npos);
  other = run;
  other.shots[1].shot["set"] = {{"samples", 4}};
  EXPECT_NE(refusalOf(run, other).find("set {\"samples\":4}"), std::string::npos);
  EXPECT_NE(refusalOf(other, run).find("set null"), std::string::npos);
}

}  // namespace times_test
}  // namespace strobe::bench::test
