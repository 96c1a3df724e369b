// SPDX-License-Identifier: MIT
// `strobe render --budget-ms` chooses the quality by times and records it, so that the picture can be drawn again.
#include <gtest/gtest.h>

#include "base/json.h"
#include "program/run.h"

namespace strobe::testing {
namespace budget_test {

const std::string kShot = "render adaptive --scene oracles/bar --size 32x16 ";

class BudgetedRender : public ::testing::Test {
 protected:
  Outcome draw(const std::string& options, const std::string& name) {
    return run(kShot + options + " -o " + (folder_ / (name + ".exr")));
  }
  Json record(const std::string& name) { return Json::parse(contentOf(folder_ / (name + ".record.json"))); }

  TemporaryFolder folder_;
};

TEST_F(BudgetedRender, RecordsTheQualityAsASetting) {
  Outcome outcome = draw("--budget-ms 100000 --set quality=0.8", "budget");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("quality=1: a frame takes "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find(" of 100000 ms (chosen in "), std::string::npos) << outcome.err;
  ASSERT_EQ(draw("--set quality=1", "hand").exit_code, 0);
  EXPECT_EQ(record("budget"), record("hand"));
  ASSERT_EQ(run("render --record " + (folder_ / "budget.record.json") + " -o " + (folder_ / "again.exr")).exit_code, 0);
  EXPECT_EQ(record("budget"), record("again"));
}

TEST_F(BudgetedRender, WarnsOfAMissedBudget) {
  Outcome outcome = draw("--budget-ms 0.000001", "low");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("warning: quality=0: a frame takes "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find(", more than the budget of 1e-06 ms"), std::string::npos) << outcome.err;
  EXPECT_EQ(record("low")["shot"]["set"], Json({{"quality", 0.0}}));
}

}  // namespace budget_test
}  // namespace strobe::testing
