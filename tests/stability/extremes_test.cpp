// SPDX-License-Identifier: MIT
// Every extreme case with every pipeline and preset, and a failing example for each kind of check. The short form
// leaves out the two scenes with many triangles: they take half of the time, and tests of the tree and of large scenes
// find the same mistakes.
#include "stability/extremes.h"

#include <set>

#include "common/all_cases.h"
#include "common/home.h"
#include "oracle/render.h"

namespace strobe::stability {
namespace extremes_test {

// Case names only: each test evaluates the checks of its case.
const std::vector<Extreme>& cases() {
  static const Extremes extremes =
      readExtremes(Home(std::vector{home().shipped()}, {}, STROBE_PROGRAM_FILE), {}, std::vector<std::string>());
  return extremes.cases;
}

class ExtremeCases : public oracle::RenderTest, public ::testing::WithParamInterface<size_t> {};

TEST_P(ExtremeCases, Holds) {
  const std::string name = cases()[GetParam()].name;
  if (!allCases() && (name == "thousands_of_instances" || name == "a_million_triangles"))
    GTEST_SKIP() << "runs with --all";
  static const std::vector<Variant> methods = methodsOf(home(), bench().limits);
  const Extremes extremes = readExtremes(home(), bench().limits, std::vector<std::string>{name});
  const Extreme& extreme = extremes.cases[GetParam()];
  ASSERT_FALSE(extreme.checks.empty());
  for (const ExtremeOutcome& outcome : runExtreme(bench(), methods, extremes, extreme))
    for (const std::string& failure : outcome.failures)
      ADD_FAILURE() << outcome.method << ": " << failure << "\n(" << extreme.says << ")\n" << outcome.command;
}

INSTANTIATE_TEST_SUITE_P(Case, ExtremeCases, ::testing::Range<size_t>(0, cases().size()),
                         [](const auto& index) { return cases()[index.param].name; });

TEST(ExtremeTable, HasCasesOfManyKindsWithUniqueNames) {
  std::set<std::string> clauses, names;
  for (const Extreme& extreme : cases()) {
    clauses.insert(extreme.clause);
    EXPECT_TRUE(names.insert(extreme.name).second) << extreme.name;
    EXPECT_TRUE(extreme.checks.empty()) << extreme.name;
  }
  EXPECT_GE(clauses.size(), 15u);
  EXPECT_GE(names.size(), 118u);
}

// ---- Each kind of check, on a bar of value 1 over 0 that moves by 8 px

Json barShot(double displacement_px) {
  return {{"scene", "oracles/bar"},
          {"size", {48, 4}},
          {"frame", 0},
          {"scene_set",
           {{"width", 48},
            {"height", 4},
            {"left", 16},
            {"right", 32},
            {"d_f", displacement_px},
            {"foreground", 1},
            {"background", 0}}},
          {"set", {{"limit", 10}, {"tile", 8}}}};
}

class Checks : public oracle::RenderTest {
 protected:
  static std::vector<std::string> failures(const std::string& kind, const Json& fields, double displacement_px = 8,
                                           const std::string& pipeline = "mcguire2012") {
    static const Extremes extremes = readExtremes(home(), bench().limits, std::vector<std::string>());
    static const std::vector<Variant> methods = methodsOf(home(), bench().limits);
    Json json = {{"check", kind}, {"shot", barShot(displacement_px)}};
    json.update(fields);
    Extreme extreme{"x", "", "", {readCheck(json)}};
    auto method =
        std::find_if(methods.begin(), methods.end(), [&](const Variant& m) { return m.pipeline == pipeline; });
    return runExtreme(bench(), {*method}, extremes, extreme).front().failures;
  }
  static size_t count(const std::string& kind, const Json& fields, double displacement_px = 8,
                      const std::string& pipeline = "mcguire2012") {
    return failures(kind, fields, displacement_px, pipeline).size();
  }
};

TEST_F(Checks, PassAndFailCorrectly) {
  const Json none = Json::object();
  EXPECT_EQ(count("draws", none), 0u);
  EXPECT_EQ(count("as_captured", none, 0), 0u);
  EXPECT_EQ(count("as_captured", none, 8), 1u);
  EXPECT_EQ(count("as_captured", {{"pixels", 48 * 4}}, 8), 0u);
  EXPECT_EQ(count("as_captured", {{"of", barShot(0)}, {"by", "truth"}}, 0, "ground_truth"), 0u);
  EXPECT_EQ(count("within", {{"low", 0}, {"high", 1}}), 0u);
  EXPECT_EQ(count("within", {{"low", 0.1}, {"high", 1}}), 1u);
  EXPECT_EQ(count("nearer", none), 0u);
  EXPECT_EQ(count("nearer", none, 0), 1u);  // an exact picture leaves no room for improvement
  EXPECT_EQ(count("same", {{"other", barShot(8)}, {"tolerance", 0}, {"share", 0}}), 0u);
  EXPECT_EQ(count("same", {{"other", barShot(4)}, {"tolerance", 0}, {"share", 0}}), 1u);
  EXPECT_EQ(count("sharp_at", {{"pixel", {20, 1}}, {"value", 1}, {"tolerance", 1e-6}}), 0u);
  EXPECT_EQ(count("sharp_at", {{"pixel", {20, 1}}, {"value", 0.9}, {"tolerance", 1e-6}}), 1u);
  EXPECT_EQ(count("silent", {{"text", "farther than the limit"}}), 0u);
  EXPECT_EQ(count("warns", {{"text", "farther than the limit"}}), 1u);
}

// Exact displacements: the bar's, and 0 elsewhere. `false` accepts any value at a pixel.
TEST_F(Checks, CompareEachPixelWithTheExactValue) {
  std::vector<Json> right;
  for (int i = 0; i < 48 * 4; ++i) {
    right.push_back(i % 48 >= 16 && i % 48 < 32 ? 8 : 0);
    right.push_back(0);
  }
  EXPECT_EQ(count("displacement", {{"exact", right}, {"share", 0}, {"tolerance_px", 1e-3}}), 0u);
  right[2 * 20] = 9;
  EXPECT_EQ(count("displacement", {{"exact", right}, {"share", 0}, {"tolerance_px", 1e-3}}), 1u);
  right[2 * 20] = false;
  EXPECT_EQ(count("displacement", {{"exact", right}, {"share", 0}, {"tolerance_px", 1e-3}}), 0u);
  std::vector<double> still(48 * 4, 0);
  for (size_t i = 0; i < still.size(); ++i) still[i] = i % 48 >= 16 && i % 48 < 32;
  EXPECT_EQ(count("truth", {{"exact", still}, {"tolerance", 1e-6}, {"by", "truth"}}, 0, "ground_truth"), 0u);
  EXPECT_EQ(count("truth", {{"exact", still}, {"tolerance", 1e-6}, {"by", "truth"}}, 8, "ground_truth"), 1u);
}

TEST_F(Checks, ApplyToTheirMethods) {
  const Json impossible = {{"low", 2}, {"high", 3}};
  auto counts = [&](const char* by) {
    Json fields = impossible;
    fields["by"] = by;
    return std::array{count("within", fields, 8, "none"), count("within", fields, 8, "mcguire2012"),
                      count("within", fields, 8, "ground_truth")};
  };
  EXPECT_EQ(counts("all"), (std::array<size_t, 3>{1, 1, 1}));
  EXPECT_EQ(counts("filters"), (std::array<size_t, 3>{0, 1, 0}));
  EXPECT_EQ(counts("others"), (std::array<size_t, 3>{1, 0, 1}));
  EXPECT_EQ(counts("truth"), (std::array<size_t, 3>{0, 0, 1}));
  EXPECT_EQ(counts("all_but_truth"), (std::array<size_t, 3>{1, 1, 0}));
}

}  // namespace extremes_test
}  // namespace strobe::stability
