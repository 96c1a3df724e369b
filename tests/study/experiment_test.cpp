// SPDX-License-Identifier: MIT
// Experiment files: their points, the order of points, and errors. Without a device.
#include <gtest/gtest.h>

#include "base/frozen_home.h"
#include "common/home.h"
#include "common/source.h"
#include "program/run.h"
#include "study/points.h"

namespace strobe::study {
namespace experiment_test {

using strobe::testing::TemporaryFolder;
using strobe::testing::writeText;

// A complete experiment file.
const char* const kSamplesAndTiles = R"lua(
local experiment = require "strobe.experiment"

return experiment {
  title    = "Samples and tiles",
  question = "What does a sample buy, and does the tile size matter?",
  size     = { 160, 90 },
  shots    = { { name = "vase", scene = "living_room", camera = "main" },
               { name = "tracking", scene = "living_room", camera = "tracking" } },   -- options as on the command line
  arms     = { { name = "mcguire", pipeline = "mcguire2012" },
               { name = "hybrid", pipeline = "hybrid", set = { preset = "text" } } },
  truth    = { pipeline = "ground_truth", set = { samples = 64 } },
  vary     = { experiment.grid { samples = { 4, 8, 16 }, exposure = { 0.25, 0.5 } } },    -- parameters of arms, options of shots, scene.NAME
  skip     = function(point) return point.arm == "mcguire" and point.samples == 4 end,
  regions  = { "whole", "inner", "outer" },
  measures = { "rmse", "flip", "ms" },
  expect   = { { "more samples never hurt the hybrid's inner blur by more than a tenth",
                 function(r) return r.at { arm = "hybrid", samples = 16, region = "inner" }.rmse
                                 <= 1.1 * r.at { arm = "hybrid", samples = 4, region = "inner" }.rmse end } },
}
)lua";

Experiment readText(const std::string& text, bool evaluate = false) {
  TemporaryFolder folder;
  writeText(folder / "x.lua", text);
  return readExperiment(home(), folder / "x.lua", evaluate);
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(Points, AreShotsThenValuesThenArms) {
  Experiment experiment = readText(kSamplesAndTiles);
  EXPECT_EQ(experiment.points(), 20u) << "2 shots x 2 exposures x 3 samples x 2 arms, without 4 skipped points";
  std::vector<std::string> lines = linesOf(listOf(experiment));
  ASSERT_EQ(lines.size(), 20u);
  EXPECT_EQ(lines[0], "1  vase  exposure 0.25, samples 4  hybrid") << "axes by name; the last varies fastest";
  EXPECT_EQ(lines[1], "2  vase  exposure 0.25, samples 8  mcguire");
  EXPECT_EQ(lines[2], "3  vase  exposure 0.25, samples 8  hybrid");
  EXPECT_EQ(lines[5], "6  vase  exposure 0.5, samples 4  hybrid");
  EXPECT_EQ(lines[19], "20  tracking  exposure 0.5, samples 16  hybrid");
}

TEST(Points, SetTheParametersOfTheirAxes) {
  Experiment experiment = readText(kSamplesAndTiles);
  const Group& group = experiment.groups.back();
  lab::Shot hybrid = shotOf(experiment, group, experiment.arms[1]), truth = truthShotOf(experiment, group);
  EXPECT_EQ(hybrid.exposure, 0.5);
  EXPECT_EQ(hybrid.camera, "tracking");
  EXPECT_EQ(hybrid.width, 160);
  EXPECT_EQ(lab::commandOf(hybrid),
            "strobe render hybrid --scene living_room --size 160x90 --exposure 0.5 --anchor end --camera tracking "
            "--set preset=text --set samples=16 -o out.exr");
  EXPECT_EQ(truth.exposure, 0.5) << "options of the shot apply to truth";
  EXPECT_NE(lab::commandOf(truth).find("--set samples=64"), std::string::npos) << "parameters of arms do not";
}

TEST(Points, GiveGltfScenesNoSizeParameters) {
  Experiment experiment = readText(R"lua(
return require "strobe.experiment" {
  title = "Two scenes", size_params = { "width", "height" }, truth = { pipeline = "ground_truth" },
  shots = { { name = "lua", scene = "living_room" }, { name = "gltf", scene = "x.gltf" } },
  arms = { { name = "none", pipeline = "none" } },
})lua");
  ASSERT_EQ(experiment.groups.size(), 2u);
  EXPECT_EQ(shotOf(experiment, experiment.groups[0], experiment.arms[0]).sets.size(), 2u);
  EXPECT_TRUE(shotOf(experiment, experiment.groups[1], experiment.arms[0]).sets.empty());
  EXPECT_TRUE(truthShotOf(experiment, experiment.groups[1]).sets.empty());
}

// An experiment with fields inserted at ARM, SHOT, AXIS, MORE and LACKS.
std::string with(const std::string& arm, const std::string& shot = "", const std::string& axis = "",
                 const std::string& more = "", const std::string& lacks = "") {
  std::string text = R"lua(
local experiment = require "strobe.experiment"
return experiment {
  title = "A bar", size = { 64, 16 }, size_params = { "width", "height" },
  truth = { pipeline = "ground_truth", set = { samples = 32 } },
  arms = {
    { name = "no blur", pipeline = "none" LACKS },
    { name = "hybrid", pipeline = "hybrid" ARM },
    { name = "floor", pipeline = "ground_truth", role = "floor", set = { samples = 16 } },
  },
  shots = { { name = "bar", scene = "oracles/bar", ["scene.left"] = 20, ["scene.right"] = 50 SHOT } },
  vary = { experiment.list { name = "speed", values = { 4.7, 30 },
             at = function(v) return { ["scene.d_f"] = v } end AXIS } } MORE }
)lua";
  for (const auto& [what, given] : {std::pair<std::string, std::string>{" ARM", arm},
                                    {" SHOT", shot},
                                    {" AXIS", axis},
                                    {" MORE", more},
                                    {" LACKS", lacks}})
    text.replace(text.find(what), what.size(), given.empty() ? "" : ", " + given);
  return text;
}

void expectRefusal(const std::string& text, const std::string& wanted, bool evaluate = false) {
  try {
    readText(text, evaluate);
    ADD_FAILURE() << "accepted; expected: " << wanted;
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(wanted), std::string::npos) << error.what() << "\nexpected: " << wanted;
  }
}

TEST(Mistakes, HaveTheirPlaceAndTheNearestName) {
  expectRefusal(with("sett = {}"), "x.lua:8: arm 2 has no field 'sett'; did you mean 'set'?");
  expectRefusal(with("", "exposre = 1"), "x.lua:11: shot 1 has no field 'exposre'; did you mean 'exposure'?");
  expectRefusal(with("", "anchor = \"center\""), "did you mean 'centre'?");
  expectRefusal(with("", "camera = 3"), "'camera' of shot 1");
  expectRefusal(with("", "spin = { bar = { 0, 1, 0 } }"), "takes 4 numbers");
  expectRefusal(with("role = \"truth\""), "the role of an arm is 'truth', which is not one of method, floor");
  expectRefusal(with("", "", "scale = \"lgo\""), "not one of log, linear, even; did you mean 'log'?");
  expectRefusal(with("", "", "region = \"iner\""), "did you mean 'inner'?");
  expectRefusal(with("", "", "benign = 5"), "benign is 5, which is not one of the values");
  expectRefusal(with("", "", "scale = \"log\", values = { 4.7, 2 }"), "the values must increase, but 2 follows 4.7");
  expectRefusal(with("", "", "scale = \"log\", values = { -1, 4.7 }"),
                "-1 is negative and cannot be placed on a logarithmic scale");
  expectRefusal(with("", "", "shots = { \"bra\" }"), "did you mean 'bar'?");
  expectRefusal(with("", "", "at = function(v) return v.at_all end"), "at(4.7) of axis 'speed' fails");
  expectRefusal(with("", "", "", "measures = { \"rsme\" }"), "did you mean 'rmse'?");
  expectRefusal(with("", "", "", "regions = { \"hiden\" }"), "did you mean 'hidden'?");
  expectRefusal(with("", "", "", "skip = function() return true end"), "the experiment has no points");
  expectRefusal(with("", "", "", "expect = { { \"x\", function() end, axis = \"sped\" } }"), "did you mean 'speed'?");
  expectRefusal(with("", "", "", "layout = { tabel = {} }"), "did you mean 'table'?");
  expectRefusal("return {}", "does not return experiment { ... }");
}

// Unknown names in the settings of an arm, an axis, a shot or truth: the error has the line and the entry.
TEST(Mistakes, OfSettingsNameTheirEntry) {
  for (const auto& [text, wanted] : {
           std::pair<std::string, std::string>{
               with("set = { edg = 4 }"),
               "x.lua:8: arm 'hybrid': --set edg=4: the pipeline has no parameter 'edg'; did you mean 'edge'?"},
           {with("set = { [\"edges.depth\"] = 0.01 }"),
            "x.lua:8: arm 'hybrid': --set edges.depth=0.01: unknown node 'edges'"},
           {with("box = { tap = 4 }"), "x.lua:8: arm 'hybrid': --set tap=4: "},
           {with("", "move = { bra = { 1, 0, 0 } }"),
            "x.lua:11: shot 'bar': bar has no node 'bra'; did you mean 'bar'?"},
           {with("", "camera = \"mian\""),
            "x.lua:11: shot 'bar': --camera mian: bar has no camera 'mian'; did you mean 'main'?"},
           {with("", "", "at = function(v) return { camera = v == 30 and \"mian\" or \"main\" } end"),
            "x.lua:13: axis 'speed', shot 'bar': --camera mian: bar has no camera 'mian'; did you mean 'main'?"},
           {with("", "follow = \"bra\""), "x.lua:11: shot 'bar': --follow bra: bar has no node 'bra'"},
           {with("", "animation = \"al\""), "x.lua:11: shot 'bar': --animation al: bar has no animation 'al'"},
           {with("", "scene = \"oracles/bra\""), "x.lua:11: shot 'bar': unknown scene 'oracles/bra'"},
           {with("", "[\"scene.lft\"] = 20"),
            "x.lua:11: shot 'bar': --set scene.lft=20: the scene has no parameter 'lft'"},
           {with("", "truth = { sampels = 4 }"), "x.lua:11: shot 'bar', truth: --set sampels=4: "},
           {with("", "", "at = function() return { samples = 4 } end"),
            "x.lua:13: axis 'speed', arm 'no blur': --set samples=4: the pipeline has no parameter 'samples'; "
            "lacks = { \"samples\" } draws the arm without it"},
       })
    expectRefusal(text, wanted, true);
  std::string misspelt = with("");
  misspelt.replace(misspelt.find("\"none\""), 6, "\"noen\"");
  expectRefusal(misspelt, "x.lua:7: arm 'no blur': unknown pipeline 'noen'; did you mean 'none'?", true);
}

TEST(Mistakes, OfLacksAreReported) {
  const std::string axis = "at = function() return { samples = 4 } end";
  expectRefusal(with("", "", axis, "", "lacks = { \"sample\" }"),
                "x.lua:7: 'lacks' of arm 'no blur' names 'sample', which is neither an axis nor a parameter that an "
                "axis sets; did you mean 'samples'?");
  for (const char* name : {"samples", "speed"}) {
    Experiment experiment = readText(with("", "", axis, "", fmt::format("lacks = {{ \"{}\" }}", name)), true);
    EXPECT_TRUE(shotOf(experiment, experiment.groups[0], experiment.arms[0]).sets.size() <
                shotOf(experiment, experiment.groups[0], experiment.arms[1]).sets.size())
        << name;
  }
}

// Expectations are evaluated on placeholder results: unknown names and unmeasured values are found.
TEST(Mistakes, OfExpectationsAreFoundBeforeDrawing) {
  auto expecting = [](const std::string& body) {
    return with("", "", "", "measures = { \"rmse\" }, expect = { { \"it is\", function(r)\n" + body + "\nend } }");
  };
  for (const auto& [body, wanted] : {
           std::pair<std::string, std::string>{"return r.at { arm = 'hybird' }.rmse < 1",
                                               "unknown arm 'hybird'; did you mean 'hybrid'?"},
           {"return r.at { shot = 'bra' }.rmse < 1", "unknown shot 'bra'; did you mean 'bar'?"},
           {"return r.at { region = 'iner' }.rmse < 1", "unknown region 'iner'; did you mean 'inner'?"},
           {"return r.at { sped = 30 }.rmse < 1", "unknown axis 'sped'; did you mean 'speed'?"},
           {"return r.at { speed = 3 }.rmse < 1", "axis 'speed' has no value 3"},
           {"return r.at { speed = 30 }.rsme < 1", "unknown measure 'rsme'; did you mean 'rmse'?"},
           {"return r.at { arm = 'floor', shot = 'bar' }.rsme < 1", "unknown measure 'rsme'"},
           {"return r.att { speed = 30 }.rmse < 1", "r has no 'att'; did you mean 'at'?"},
       })
    expectRefusal(expecting(body), "x.lua:14: expectation 'it is': " + wanted);
  for (const char* body :
       {"return r.at { speed = 30 }.rmse > 7", "return r.at { arm = 'floor', region = 'hidden' }.rmse < 2",
        "return nil", "local best\nif r.at {}.rmse > 2 then best = 3 end\nreturn best < 4"})
    EXPECT_EQ(readText(expecting(body)).expectations, 1u) << body;
}

TEST(Mistakes, OfSkippedPointsAreFound) {
  expectRefusal(with("", "", "", "skip = function(point) return point.sped == 3 end"),
                "skip fails: a point has no 'sped'; did you mean 'speed'?");
}

TEST(Mistakes, CurvesWithoutASuitableAxisAreRefused) {
  expectRefusal(
      with("", "", "region = \"inner\"", "layout = { curves = {} }"),
      "x.lua:13: there are no curves to draw: curves need an axis with `region`, `scale` and `benign`; axis 'speed' "
      "has no scale, benign");
  EXPECT_EQ(readText(with("", "", "region = \"inner\", scale = \"log\", benign = 30", "layout = { curves = {} }"))
                .axes.size(),
            1u);
}

TEST(Only, KeepsSelectedPoints) {
  auto listed = [](const std::string& only) {
    Experiment experiment = readText(kSamplesAndTiles);
    keepOnly(experiment, only);
    EXPECT_TRUE(experiment.partial);
    return linesOf(listOf(experiment)).size();
  };
  EXPECT_EQ(listed("arm=hybrid"), 12u);
  EXPECT_EQ(listed("arm=hybrid,samples=4,samples=8"), 8u);
  EXPECT_EQ(listed("shot=vase,exposure=0.25"), 5u);
  EXPECT_EQ(listed("samples"), 20u) << "every point has this axis";
  Experiment experiment = readText(kSamplesAndTiles);
  experiment.arms[1].name = "hybrid, best (again)";
  keepOnly(experiment, "arm=hybrid, best (again),samples=4");
  EXPECT_EQ(linesOf(listOf(experiment)).size(), 4u) << "a name with a comma";
  experiment = readText(kSamplesAndTiles);
  experiment.measures.push_back("ms_ratio");
  experiment.base = "mcguire";
  keepOnly(experiment, "arm=hybrid,shot=vase,samples=16");
  EXPECT_EQ(linesOf(listOf(experiment)).size(), 3u) << "two exposures, and the base of time ratios";
  experiment = readText(kSamplesAndTiles);
  for (const auto& [only, wanted] : {std::pair<std::string, std::string>{"arm=hybird", "did you mean 'hybrid'?"},
                                     {"sampels=4", "did you mean 'samples'?"},
                                     {"samples=5", "there are 4, 8, 16"},
                                     {"arm=mcguire,samples=4", "no point matches"}}) {
    try {
      keepOnly(experiment, only);
      ADD_FAILURE() << only;
    } catch (const Error& error) {
      EXPECT_EQ(error.exitCode(), 2);
      EXPECT_NE(std::string(error.what()).find(wanted), std::string::npos) << error.what();
    }
  }
}

TEST(Each, GivesOneAxisAfterTheOther) {
  const std::string axes = R"(vary = { experiment.each {
    experiment.list { name = "speed", values = { 1, 2 }, at = function(v) return { ["scene.d_f"] = v } end },
    experiment.grid { samples = { 4, 8 }, exposure = { 0.5 } } } })";
  Experiment experiment = readText(with("", "", "", axes, "lacks = { \"samples\" }"));
  std::vector<std::string> lines = linesOf(listOf(experiment));
  ASSERT_EQ(lines.size(), 12u);
  EXPECT_EQ(lines[0], "1  bar  speed 1  no blur");
  EXPECT_EQ(lines[11], "12  bar  exposure 0.5, samples 8  floor");
  lab::Shot none = shotOf(experiment, experiment.groups.back(), experiment.arms[0]);
  EXPECT_EQ(lab::commandOf(none).find("samples"), std::string::npos) << "the arm lacks the parameter";
}

// Points of the sample experiment's first shot with arm hybrid, as "NAME VALUE, ...".
std::vector<std::string> pointsOf(const std::string& vary) {
  std::string text = kSamplesAndTiles;
  size_t from = text.find("experiment.grid"), to = text.find(" }", text.find("0.5 } }") + 6);
  text.replace(from, to - from, vary);
  text.erase(text.find("  expect   ="), text.rfind("}\n") - text.find("  expect   ="));
  text.erase(text.find("  skip     ="), text.find("  regions  =") - text.find("  skip     ="));
  Experiment experiment = readText(text);
  keepOnly(experiment, "shot=vase,arm=hybrid");
  std::vector<std::string> points;
  for (const Group& group : experiment.groups) points.push_back(describe(experiment, group));
  return points;
}

using Lines = std::vector<std::string>;

TEST(Vary, ZipPairsValuesByPosition) {
  EXPECT_EQ(pointsOf("experiment.zip { samples = { 8, 16 }, exposure = { 0.5, 0.25 } }"),
            (Lines{"exposure 0.5, samples 8", "exposure 0.25, samples 16"}));
}

TEST(Vary, AblationIsTheBaseThenEachSingleChange) {
  EXPECT_EQ(pointsOf("experiment.ablation({ samples = 8, tile = 40 }, { tile = { 20, 40 }, samples = { 16 } })"),
            (Lines{"samples 8, tile 40", "samples 16, tile 40", "samples 8, tile 20"}))
      << "a change to the base's value is not another point";
}

TEST(Vary, ValuesAreSpacedLinearlyOrByAFactor) {
  EXPECT_EQ(pointsOf("experiment.grid { exposure = experiment.linear(0.25, 0.75, 3) }"),
            (Lines{"exposure 0.25", "exposure 0.5", "exposure 0.75"}));
  EXPECT_EQ(pointsOf("experiment.grid { exposure = experiment.log(0.01, 1, 3) }"),
            (Lines{"exposure 0.01", "exposure 0.1", "exposure 1"}));
}

// scipy.stats.qmc.Sobol(3, scramble=False).random(8)
TEST(Vary, SobolPointsMatchTheSequence) {
  const double expected[8][3] = {{0, 0, 0},          {.5, .5, .5},       {.75, .25, .25},    {.25, .75, .75},
                                 {.375, .375, .625}, {.875, .875, .125}, {.625, .125, .875}, {.125, .625, .375}};
  Lines lines;
  for (const auto& [a, b, c] : expected)
    lines.push_back(fmt::format("exposure {}, scene.hue {}, tile {}", a, 100 + 200 * b, 8 + int(c * 9)));
  EXPECT_EQ(pointsOf("experiment.sobol(8, { exposure = { 0.0, 1.0 }, [\"scene.hue\"] = { 100.0, 300.0 }, "
                     "tile = { 8, 16 } })"),
            lines);
}

// SplitMix64 by its definition, computed in Python: 0.56656, 0.74578, 0.97100, 0.44436; 65^0.74578 = 22.5, 65^0.44436 =
// 6.4.
TEST(Vary, RandomPointsFollowFromTheSeed) {
  EXPECT_EQ(
      pointsOf(
          "experiment.random(2, 1, { mask = { \"seed\", \"relative\", \"all\" }, samples = { 1, 64, log = true } })"),
      (Lines{"mask relative, samples 22", "mask all, samples 6"}));
}

TEST(Vary, MistakesHaveTheirLine) {
  for (const auto& [vary, wanted] :
       {std::pair<std::string, std::string>{"experiment.zip { samples = { 8, 16 }, exposure = { 0.5 } }",
                                            "got 2 values of 'samples' and 1 of 'exposure'"},
        {"experiment.grid { samples = {} }", "'samples' is empty instead of a list"},
        {"experiment.ablation({ samples = 8 }, { sample = { 4 } })",
         "not in the base of the ablation; did you mean 'samples'?"},
        {"experiment.sobol(0, { samples = { 1, 2 } })", "the count must be a whole number, at least 1"},
        {"experiment.random(3, 1.5, { samples = { 1, 2 } })", "the seed of random must be a whole number"},
        {"experiment.sobol(3, { samples = { 4, 2 } })", "the range of 'samples' is empty: 4 to 2"},
        {"experiment.sobol(3, { exposure = { 0.0, 2.0, log = true } })", "must be two numbers above 0"}}) {
    try {
      pointsOf(vary);
      ADD_FAILURE() << vary;
    } catch (const Error& error) {
      std::string what = error.what();
      EXPECT_NE(what.find("x.lua:13: "), std::string::npos) << what;
      EXPECT_NE(what.find(wanted), std::string::npos) << what;
    }
  }
}

// A pipeline and a scene beside an experiment are edited after they are copied.
TEST(ExperimentInputs, FilesBesideAnExperimentAreReadFromTheCopy) {
  TemporaryFolder folder;
  const Path project = folder.path() / "p", beside = project / "experiments";
  writeFileAtomically(project / Home::kProjectFile, "");
  writeFileAtomically(beside / "none.lua", strobe::readText(home().at("scripts/pipelines/none.lua")));
  writeFileAtomically(beside / "card.lua", strobe::testing::kCardScene);
  writeFileAtomically(beside / "x.lua", R"lua(return require "strobe.experiment" {
    title = "Beside", truth = { pipeline = "ground_truth" }, shots = { { name = "card", scene = "card.lua" } },
    arms = { { name = "none", pipeline = "none.lua" } } })lua");
  const Home original({project, home().shipped()}, home().data(), home().program());
  FrozenHome frozen(original, folder / "copy");
  auto commandIn = [&](const Home& of) {
    Experiment experiment = readExperiment(of, beside / "x.lua");
    EXPECT_EQ(experiment.inputs.count("project:experiments/x.lua"), 1u);
    EXPECT_EQ(experiment.arms[0].pipeline, beside / "none.lua");
    return lab::commandOf(shotOf(experiment, experiment.groups[0], experiment.arms[0]));
  };
  const std::string command = commandIn(original);
  for (const char* name : {"none.lua", "card.lua"}) writeFileAtomically(beside / name, "error 'edited'");
  EXPECT_THROW(readExperiment(original, beside / "x.lua"), Error);
  EXPECT_EQ(commandIn(frozen.home()), command);
  std::vector<script::Dependency> files;
  script::evaluateScene(frozen.home(), beside / "card.lua", {}, &files);
  EXPECT_TRUE(std::any_of(files.begin(), files.end(), [](const auto& file) {
    return file.shown == "experiments/card.lua";
  })) << "the file has its name in the home";
}

// A sweep reads a copy of the home; results name the files of the original home.
TEST(ExperimentInputs, PathsInTheHomeGetTheHomesNames) {
  const std::string file = (sourceFolder() / "experiments/pipelines/hybrid_steps.lua").string();
  Inputs inputs = {{file, "1"}, {"strobe:shaders/a.glsl", "2"}, {"/elsewhere/x.lua", "3"}};
  nameInputs(inputs, home());
  EXPECT_EQ(inputs, (Inputs{{"/elsewhere/x.lua", "3"},
                            {"strobe:experiments/pipelines/hybrid_steps.lua", "1"},
                            {"strobe:shaders/a.glsl", "2"}}));
}

}  // namespace experiment_test
}  // namespace strobe::study
