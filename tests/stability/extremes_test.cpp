// SPDX-License-Identifier: MIT
// Every extreme case, by every pipeline and preset.
#include "stability/extremes.h"

#include "oracle/render.h"

namespace strobe::stability {
namespace {

class Extremes : public oracle::RenderTest, public testing::WithParamInterface<size_t> {};

TEST_P(Extremes, Holds) {
  static const std::vector<Method> methods = methodsOf(bench().limits);
  const Extreme& extreme = extremes()[GetParam()];
  for (const ExtremeOutcome& outcome : runExtreme(bench(), methods, extreme))
    for (const std::string& failure : outcome.failures)
      ADD_FAILURE() << outcome.method << ": " << failure << "\n(" << extreme.says << ")\n" << outcome.command;
}

INSTANTIATE_TEST_SUITE_P(Case, Extremes, testing::Range<size_t>(0, extremes().size()),
                         [](const auto& index) { return extremes()[index.param].name; });

TEST(ExtremeTable, HasEveryClause) {
  std::map<std::string, int> clauses;
  for (const Extreme& extreme : extremes()) ++clauses[extreme.clause];
  EXPECT_GE(clauses.size(), 10u);
  for (const auto& [clause, count] : clauses) EXPECT_GE(count, 1) << clause;
}

}  // namespace
}  // namespace strobe::stability
