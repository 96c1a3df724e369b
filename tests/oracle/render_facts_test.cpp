// SPDX-License-Identifier: MIT
// Omitted work changes no picture. Every pipeline and preset, and settings with other graphs, are compared with
// themselves with everything modelled, on scenes that lack certain features. Without motion each method equals the
// raster image. All comparisons are bit for bit, except for rays at other times and for reordered means
// (expectFewDiffer). The tests catch a fact that is proven wrongly, an omitted pass that a picture needs, and a
// stand-in that differs from the image of the omitted pass.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "common/all_cases.h"
#include "common/home.h"
#include "lab/frame.h"
#include "lab/record.h"
#include "oracle/render.h"

using namespace strobe;
using namespace strobe::lab;
using strobe::oracle::shotOf;
using strobe::oracle::with;

namespace render_facts_test {

constexpr int kWidth = 48, kHeight = 30;

// Tolerance of reordered means of few numbers: a few last places of single precision.
const double kRounded = std::ldexp(1., -21);
// Tolerance of static surfaces that a ray hits at each time instead of once: their position in the raster image is
// rounded, and so is the shading there.
const double kMetAnew = std::ldexp(1., -17);

struct Case {
  std::string name;
  Shot shot;
  std::vector<std::string> absent;
};

// Bars and cards in front of each other under a lamp; cut-out paper; a blended card; one-sided cards; a plane whose
// light casts no shadow; a post deformed by joints, if the shared scenes are present.
std::vector<Case> cases() {
  Shot follows = shotOf("crowd", kWidth, kHeight, {{"speed", 0}});
  follows.moves = {"camera=0.2,0,0"};
  Shot held = follows;
  held.camera_blur = held.object_blur = 0;
  Shot instant = follows;
  instant.exposure = 0;
  std::vector<Case> all = {
      {"static crowd",
       shotOf("crowd", kWidth, kHeight, {{"speed", 0}}),
       {"motion", "curves", "alpha", "blend", "one_sided", "deforms"}},
      {"crowd", shotOf("crowd", kWidth, kHeight), {"curves", "alpha", "blend", "one_sided", "deforms"}},
      {"crowd seen from a moving camera", follows, {"alpha", "blend", "one_sided", "deforms"}},
      {"crowd without motion blur", held, {"motion", "curves", "alpha", "blend", "one_sided", "deforms"}},
      {"crowd with exposure 0",
       instant,
       {"motion", "curves", "alpha", "blend", "one_sided", "deforms", "before", "after"}},
      {"cut out", shotOf("cut_out", kWidth, kHeight), {"motion", "curves", "blend", "one_sided", "shadows", "deforms"}},
      {"veil", shotOf("veil", kWidth, kHeight, {{"shift", 9}}), {"curves", "one_sided", "shadows", "deforms"}},
      {"sides", shotOf("sides", kWidth, kHeight), {"motion", "curves", "alpha", "blend", "shadows", "deforms"}},
      {"sliding square",
       shotOf("quad_2d", kWidth, kHeight,
              {{"left", 18}, {"right", 28}, {"top", 10}, {"bottom", 18}, {"d_x", 8}, {"d_y", -4}}),
       {"curves", "alpha", "blend", "one_sided", "shadows", "deforms"}},
      {"lit",
       shotOf("lit", kWidth, kHeight),
       {"motion", "curves", "alpha", "blend", "one_sided", "shadows", "deforms"}},
  };
  Shot bent;
  bent.width = kWidth, bent.height = kHeight;
  bent.scene = home().data().value_or("") / "scenes/khronos_samples/RiggedSimple.glb";
  bent.frame = 20;
  if (std::filesystem::exists(bent.scene)) all.push_back({"a bent post", bent, {"alpha", "blend", "shadows"}});
  return all;
}

// Settings with graphs other than those by presets.
const std::map<std::string, std::vector<std::vector<std::string>>> kGraphs = {
    {"mcguire2012", {{"weights=uniform", "range=split"}, {"color_format=fp16"}, {"displacement=extrapolated"}}},
    {"adaptive", {{"quality=0"}, {"quality=0.6"}, {"quality=0.8", "samples=4"}}},
    {"ue5", {{"directions=two", "heavy_motion=1"}, {"half_resolution=false", "color_format=fp16"}}},
    {"guertin2014", {{"second_share=variance", "color_format=fp16"}, {"uniform_path=false"}}},
    {"jimenez2014", {{"color_format=fp16", "copy_below=0"}}},
    {"hybrid",
     {{"mask.min_displacement=0", "displaced_position.min_displacement=0", "edge=canny"},
      {"edge=plane"},
      {"weights=guertin2014"},
      {"velocity_format=fp16", "color_format=fp16", "depth_encoding=reversed"}}},
    {"hybrid_layered",
     {{"trajectory=quadratic"},
      {"trajectory=arc"},
      {"range=split"},
      {"termination=motion", "advance=origin_kept"},
      {"velocity_format=fp16", "color_format=fp16", "depth_encoding=reversed"}}},
    {"accumulation", {{"samples=4", "reuse=none"}, {"samples=3", "reuse=blended"}}},
    {"eevee", {{"steps=2", "weights=jimenez2014"}, {"steps=5", "displacement=extrapolated"}}},
    {"ground_truth", {{"samples=4"}, {"samples=2", "mode=raster"}}},
};

class RenderFacts : public oracle::RenderTest {
 protected:
  // Settings of every preset, then the settings in kGraphs.
  static std::vector<std::vector<std::string>> graphsOf(const std::string& pipeline) {
    std::vector<std::vector<std::string>> graphs;
    for (const auto& preset : bench().evaluate(pipeline, {})->pipeline.presets)
      graphs.push_back({"preset=" + preset.name});
    if (graphs.empty() && pipeline != "ground_truth") graphs.push_back({});
    auto more = kGraphs.find(pipeline);
    if (more != kGraphs.end()) graphs.insert(graphs.end(), more->second.begin(), more->second.end());
    return graphs;
  }

  static Picture everythingOf(Shot shot) {
    shot.model_everything = true;
    return render(shot);
  }

  static bool isMethod(const std::string& pipeline) {
    return bench().evaluate(pipeline, {})->pipeline.kind == plan::PipelineDesc::Kind::Method;
  }

  void compare(const Case& one, const std::string& pipeline, const std::vector<std::string>& settings) {
    SCOPED_TRACE(fmt::format("{}: {} {}", one.name, pipeline, fmt::join(settings, " ")));
    Shot shot = with(one.shot, pipeline, settings, "centre");
    Picture required = render(shot), everything = everythingOf(shot);
    ASSERT_EQ(required.frame.outputs.size(), everything.frame.outputs.size());
    for (const auto& [name, image] : everything.frame.outputs)
      if (name != "color" || !mayDiffer(required))
        EXPECT_EQ(hashOf(required.frame.outputs.at(name)), hashOf(image)) << name;
    bool halves = std::count(settings.begin(), settings.end(), "color_format=fp16");
    if (mayDiffer(required)) {
      double rounded = halves                          ? std::ldexp(1., -11)
                       : hasGround(required)           ? kMetAnew
                       : takesMeansOtherwise(required) ? kRounded
                                                       : 0;
      // Reordered means differ by no more in any pixel. Static surfaces may come from a ray or from rasterisation.
      const int most = hasGround(required) ? kWidth * kHeight / 100 : 0;
      expectFewDiffer(oracle::colorOf(required), oracle::colorOf(everything), rounded, most);
    }
    EXPECT_EQ(required.record["pipeline"]["plan"], everything.record["pipeline"]["plan"]);
    bool still = std::count(one.absent.begin(), one.absent.end(), "motion") && isMethod(pipeline) &&
                 !required.record["counters"].contains("sample.not_finite");  // excludes pipelines that contain truth
    if (!still || required.frame.outputs.at("color").format != "rgba32f") return;
    Picture capture = render(with(
        one.shot, "none", halves ? std::vector<std::string>{"shade.color_format=fp16"} : std::vector<std::string>{}));
    EXPECT_TRUE(oracle::identical(oracle::colorOf(required), oracle::colorOf(capture)));
  }

  // With a static background, static surfaces enter the mean at once, or equal the raster image where nothing moves.
  // With everything modelled they enter sample by sample.
  static bool hasGround(const Picture& picture) {
    return picture.record["counters"].contains("over_background.samples");
  }
  static bool takesMeansOtherwise(const Picture& picture) {
    const Json& passes = picture.record["counters"];
    return hasGround(picture) || passes.contains("adaptive_times.samples");
  }

  static bool mayDiffer(const Picture& picture) { return takesMeansOtherwise(picture); }

  // `rounded`: allowed relative difference of a colour; `most`: number of pixels that may exceed it.
  static void expectFewDiffer(const image::Image& a, const image::Image& b, double rounded, int most) {
    int differ = 0;
    for (int y = 0; y < a.height; ++y)
      for (int x = 0; x < a.width; ++x) {
        bool same = true;
        for (int c = 0; c < 3; ++c) {
          double most = rounded * std::max(std::abs(a.at(x, y, c)), std::abs(b.at(x, y, c)));
          same = same && std::abs(a.at(x, y, c) - b.at(x, y, c)) <= most;
        }
        differ += !same;
      }
    EXPECT_LE(differ, most);
  }

  static std::vector<std::string> nodesOf(const Picture& picture) {
    std::vector<std::string> nodes;
    for (const auto& step : picture.frame.times) nodes.push_back(step.name);
    return nodes;
  }

  // Compares a preset in every scene; in the short form, in the moving crowd and every third scene. Compares another
  // graph in two scenes. The scenes differ from graph to graph and from pipeline to pipeline.
  void compareAll(const std::string& pipeline) {
    const std::vector<Case> scenes = cases();
    const std::vector<std::vector<std::string>> graphs = graphsOf(pipeline);
    const auto more = kGraphs.find(pipeline);
    const size_t whole = graphs.size() - (more == kGraphs.end() ? 0 : more->second.size());
    for (size_t i = 0; i < graphs.size(); ++i)
      for (size_t k = 0; k < scenes.size(); ++k)
        if (i < whole ? allCases() || k == 1 || k % 3 == (i + pipeline.size()) % 3
                      : k == i % scenes.size() || k == (i + 3) % scenes.size())
          compare(scenes[k], pipeline, graphs[i]);
  }
};

TEST_F(RenderFacts, ScenesHaveTheExpectedFacts) {
  for (const Case& one : cases()) {
    Shot shot = with(one.shot, "none", {}, "centre");
    auto held = bench().scene(shot);
    std::vector<std::string> absent = one.absent;
    shot.shutter_curve = "triangle";
    EXPECT_EQ(absentFacts(frameOf(shot, held->scene)), absent) << one.name;
    shot.shutter_curve = "box";
    absent.push_back("weighted");
    EXPECT_EQ(absentFacts(frameOf(shot, held->scene)), absent) << one.name;
    shot.model_everything = true;
    EXPECT_TRUE(absentFacts(frameOf(shot, held->scene)).empty());
  }
}

// Facts about the two ends of the exposure: an end at the raster time is not required.
TEST_F(RenderFacts, AnchorsRequireTheirEndsOfTheExposure) {
  const std::map<std::string, std::vector<std::string>> lacked = {
      {"end", {"after"}}, {"centre", {}}, {"start", {"before"}}};
  for (const auto& [anchor, absent] : lacked) {
    Shot shot = with(cases()[1].shot, "hybrid_layered", {}, anchor);
    std::vector<std::string> found = absentFacts(frameOf(shot, bench().scene(shot)->scene));
    std::erase_if(found, [](const std::string& fact) { return fact != "before" && fact != "after"; });
    EXPECT_EQ(found, absent) << anchor;
    EXPECT_EQ(hashOf(render(shot).frame.outputs.at("color")), hashOf(everythingOf(shot).frame.outputs.at("color")))
        << anchor;
  }
}

TEST_F(RenderFacts, OmittedWorkChangesNoPipeline) {
  for (const std::string& name : script::pipelineNames(bench().home()))
    if (name.rfind("hybrid", 0) != 0) compareAll(name);
}

TEST_F(RenderFacts, OmittedWorkChangesNoHybrid) {
  for (const char* name : {"hybrid", "hybrid_layered"}) compareAll(name);
}

TEST_F(RenderFacts, FactsAreInTheRecord) {
  Picture still = render(with(cases()[0].shot, "hybrid_layered")),
          moving = render(with(cases()[1].shot, "hybrid_layered"));
  EXPECT_EQ(still.record["facts"], Json::array({"shadows", "before"}));
  EXPECT_EQ(moving.record["facts"], Json::array({"motion", "shadows", "before"}));
  EXPECT_EQ(everythingOf(with(cases()[0].shot, "hybrid_layered")).record["facts"].size(), 10u);
}

// Displacements may predict a wrong motion after the raster time. The moving rectangle contains the predicted motion.
TEST_F(RenderFacts, MovingRectangleContainsExtrapolatedMotion) {
  const std::vector<std::vector<std::string>> paths = {{"displacement=extrapolated"},
                                                       {"displacement=extrapolated", "trajectory=quadratic"},
                                                       {"trajectory=line"},
                                                       {"trajectory=quadratic"},
                                                       {"trajectory=arc"}};
  for (double after : {-6., 60.})
    for (const char* anchor : {"end", "centre", "start"})
      for (std::vector<std::string> settings : paths) {
        Shot shot = shotOf("bent", 256, 32, {{"before", 20}, {"after", after}, {"top", 8}, {"bottom", 20}});
        const Shot foretold = with(shot, "hybrid_layered", settings, anchor);
        const scene::PixelArea reach = lab::frameOf(foretold, bench().scene(shot)->scene).motion.moving_rect;
        EXPECT_LT(reach.x1 - reach.x0, 256) << anchor << ' ' << after;
        EXPECT_EQ(hashOf(render(foretold).frame.outputs.at("color")),
                  hashOf(everythingOf(foretold).frame.outputs.at("color")))
            << anchor << ' ' << after << ' ' << settings[0];
      }
}

// Outside the moving rectangle, passes with a stand-in do not run; their images stay the same.
TEST_F(RenderFacts, PassesSkipPixelsOutsideTheMovingRectangle) {
  const Shot square = shotOf("quad_2d", kWidth, kHeight, {{"left", 18}, {"right", 24}, {"top", 10}, {"bottom", 15}});
  Shot shot = with(square, "hybrid_layered", {}, "end");
  shot.taps = {"mask.mask", "ray_reveal.found", "tile_max.longest", "composite.blurred"};
  Picture required = render(shot), everything = everythingOf(shot);
  for (const auto& [name, image] : everything.frame.taps)
    EXPECT_EQ(hashOf(required.frame.taps.at(name)), hashOf(image)) << name;
  const Picture none = render(with(square, "none", {}, "end"));
  EXPECT_FALSE(oracle::identical(oracle::colorOf(required), oracle::colorOf(none)));
}

// A tap of an omitted pass returns its stand-in.
TEST_F(RenderFacts, TapsOfOmittedPassesReturnStandIns) {
  Shot shot = with(cases()[0].shot, "hybrid_layered");
  shot.taps = {"composite.blurred", "mask.mask", "tile_max.longest", "gather_candidates.candidates_0"};
  Picture required = render(shot), everything = everythingOf(shot);
  for (const auto& [name, image] : everything.frame.taps)
    EXPECT_EQ(hashOf(required.frame.taps.at(name)), hashOf(image)) << name;
}

// Parts of the exposure have their own raster times, so no fact about motion is proven for them.
TEST_F(RenderFacts, PartsHaveNoFactsAboutMotion) {
  Shot shot = with(cases()[0].shot, "eevee", {}, "end");
  const plan::PipelineDesc& pipeline = bench().evaluate("eevee", {})->pipeline;
  auto absent = [&] {
    return absentFacts(frameOf(shot, bench().scene(shot)->scene, plan::earlierFrames(pipeline)), pipeline);
  };
  EXPECT_EQ(absent(), (std::vector<std::string>{"alpha", "blend", "one_sided", "deforms", "weighted"}));
  shot.exposure = 0;
  EXPECT_EQ(absent().front(), "motion");
}

// A static frame runs only the nodes of the raster image. Parts of an exposure are still drawn.
TEST_F(RenderFacts, StaticFramesRunOnlyTheRasterNodes) {
  std::vector<std::string> capture = nodesOf(render(with(cases()[0].shot, "none")));
  for (const std::string& name : script::pipelineNames(bench().home())) {
    if (isMethod(name) && !plan::hasParts(bench().evaluate(name, {})->pipeline)) {
      EXPECT_EQ(nodesOf(render(with(cases()[0].shot, name))), capture) << name;
    }
  }
}

}  // namespace render_facts_test
