// SPDX-License-Identifier: MIT
// Every invariant for every variant of every shipped pipeline, on generated scenes. Pipelines are found in their
// folder: a new pipeline, or a new value of a parameter, is covered without a line here. `strobe stability` tests more
// cases. To test one pipeline: --gtest_filter='Pipelines/Shipped.*/mcguire2012*' --gtest_fail_fast. Finds values of
// parameters whose picture breaks a property of every blur without a declared reason, above all values that no other
// test sets.
#include <gtest/gtest.h>

#include "common/home.h"
#include "oracle/render.h"
#include "session/home.h"
#include "stability/suite.h"

namespace strobe::stability {
namespace invariants_test {

using StabilityTest = oracle::RenderTest;

// ---- Shipped pipelines

struct Share {
  std::string pipeline;
  int shard, shards, thinned;
};

// NOLINTNEXTLINE(readability-identifier-naming): of GoogleTest
void PrintTo(const Share& share, std::ostream* out) { *out << share.pipeline << " " << share.shard; }

// A pipeline with presets has several times as many variants as others. In the run of tools/mutate, none of these cases
// was the first to find a mistake, so that few are drawn here; `strobe stability` draws all.
std::vector<Share> shares() {
  std::vector<Share> list;
  for (const std::string& name : home().namesIn("scripts/pipelines", ".lua")) {
    std::string text = readText(home().at("scripts/pipelines/" + name + ".lua"));
    bool few = text.find("presets") == std::string::npos;
    for (int i = 0; i < (few ? 1 : 4); ++i) list.push_back({name, i, few ? 1 : 4, few ? 12 : 48});
  }
  return list;
}

class Shipped : public StabilityTest, public ::testing::WithParamInterface<Share> {};

TEST_P(Shipped, HoldsEveryInvariantOrDeclaresWhyNot) {
  lab::Batch batch(bench());
  Options options;
  options.shard = GetParam().shard;
  options.shards = GetParam().shards;
  options.thinned = GetParam().thinned;
  StabilityReport report = check(batch, GetParam().pipeline, options);
  EXPECT_EQ(report.total().failed, 0) << textOf(report);
  EXPECT_GT(report.total().held, 0);
  // Most cases must blur, or the test would prove little; static scenes and limits of 0 are drawn too.
  bool is_blur = numberOf(*batch.evaluate(GetParam().pipeline, {}), "samples", 0) > 0;
  if (is_blur) {
    EXPECT_GE(report.blurred, report.drawn * 3 / 4);
  }
}

INSTANTIATE_TEST_SUITE_P(Pipelines, Shipped, ::testing::ValuesIn(shares()), [](const auto& info) {
  return info.param.pipeline +
         (info.param.shards > 1 ? fmt::format("_{}of{}", info.param.shard + 1, info.param.shards) : "");
});

// ---- Variants contain settings only

class Walked : public StabilityTest {};

TEST_F(Walked, WiredParametersAreNotVaried) {
  lab::Batch batch(bench());
  const VariantList found = walk(batch, "ground_truth");
  ASSERT_GT(found.variants.size(), 10u);
  int wired = 0;
  for (const Variant& variant : found.variants) {
    const plan::PipelineDesc& pipeline = *variant.description;
    for (const plan::NodeDesc& node : pipeline.nodes)
      for (const plan::PassDesc& pass : pipeline.passes)
        for (const plan::ParamDesc& param : pass.params) {
          if (pass.name != node.pass || !param.wired) continue;
          ++wired;
          for (const auto& [name, value] : variant.sets) EXPECT_NE(name, node.name + "." + param.name);
        }
  }
  EXPECT_GT(wired, 0) << "ground_truth has wired parameters";
}

// ---- Broken shaders are found, and failing cases are reduced

class Broken : public StabilityTest {
 protected:
  // Report on one invariant with an edited shader.
  StabilityReport reportOf(const std::string& shader, const std::string& from, const std::string& to,
                           const std::string& invariant) {
    home_.edit(shader, from, to);
    lab::Workbench edited(home_.home(), bench());
    lab::Batch batch(edited);
    Options options;
    options.invariants = {invariant};
    options.only = "defaults";
    options.cases = 3;
    return check(batch, "mcguire2012", options);
  }

  session::EditableHome home_;
};

int cardsIn(const std::string& command) {
  size_t at = command.find("scene.cards=");
  return at == std::string::npos ? 5 : std::stoi(command.substr(at + 12));
}

TEST_F(Broken, MissingNormalisationIsFound) {
  StabilityReport report =
      reportOf("shaders/gather/mcguire2012.glsl", "sum / all)", "sum / float(params.samples))", "constant");
  ASSERT_GT(report.failures.size(), 0u);
  EXPECT_LE(cardsIn(report.failures.front().commands.front()), 1) << textOf(report);
}

TEST_F(Broken, AsymmetricRoundingIsFound) {
  std::string symmetric = "trunc(offset + 0.5 * sign(offset))";
  StabilityReport report = reportOf("shaders/lib/blur.glsl", symmetric, "floor(offset + 0.5)", "mirrored");
  EXPECT_GT(report.failures.size(), 0u);
}

TEST_F(Broken, ExcessWeightIsFound) {
  StabilityReport report =
      reportOf("shaders/gather/mcguire2012.glsl", "all += weight;", "all += 0.75 * weight;", "convex");
  EXPECT_GT(report.failures.size(), 0u);
}

}  // namespace invariants_test
}  // namespace strobe::stability
