// SPDX-License-Identifier: MIT
// Every invariant for every variant of every pipeline that ships, on generated scenes. The pipelines are found in their
// folder: a new one, or a new value of a parameter, is covered without a line here. More cases: `strobe stability`.
// The fast subset, for those who change shaders: --gtest_filter='Shipped/*'.
#include <gtest/gtest.h>

#include "oracle/render.h"
#include "session/home.h"
#include "stability/suite.h"

namespace strobe::stability {
namespace {

using StabilityTest = oracle::RenderTest;

// ---- what is broken is found, and becomes small

class Broken : public StabilityTest {
 protected:
  // The failures of one invariant with an edited shader, and the settings of the small case.
  Report reportOf(const std::string& shader, const std::string& from, const std::string& to, const std::string& invariant) {
    home_.edit(shader, from, to);
    Renderer renderer(bench());
    Options options;
    options.invariants = {invariant};
    options.only = "defaults";
    options.cases = 8;
    return check(renderer, "mcguire2012", options);
  }

  session::EditableHome home_;
};

int cardsIn(const std::string& command) {
  size_t at = command.find("scene.cards=");
  return at == std::string::npos ? 5 : std::stoi(command.substr(at + 12));
}

TEST_F(Broken, NormalisationThatIsLeftOut) {
  Report report = reportOf("shaders/gather/mcguire2012.glsl", "vec4(sum / all,", "vec4(sum / float(params.samples),", "constant");
  ASSERT_GT(report.failures.size(), 0u);
  EXPECT_LE(cardsIn(report.failures.front().commands.front()), 1) << textOf(report);
}

TEST_F(Broken, WeightsThatAddUpToMore) {
  Report report = reportOf("shaders/gather/mcguire2012.glsl", "all += weight;", "all += 0.75 * weight;", "convex");
  EXPECT_GT(report.failures.size(), 0u);
}

}  // namespace
}  // namespace strobe::stability
