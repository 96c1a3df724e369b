// SPDX-License-Identifier: MIT
#include "script/evaluate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "home.h"
#include "plan/settings.h"

namespace strobe::script {
namespace evaluate_test {

static const char* kPipeline = R"(local pipeline = require "strobe.pipeline"
local base    = require "passes.base"
local largest = require "passes.tile.largest"
local smear   = require "passes.smear"
local add     = require "passes.add"

return pipeline {
  doc = "everything a pipeline can have",
  params = {
    method  = pipeline.choice { "smear", "truth", default = "smear", doc = "which" },
    samples = pipeline.int { 16, min = 1, max = 1024, doc = "times" },
    times   = pipeline.choice { "midpoint", "stratified", doc = "where in the exposure" },
    tile    = pipeline.int { 32, min = 2, max = 64, unit = "px", doc = "side of a tile" },
  },
  presets = {
    coarse = { doc = "fast", set = { tile = 64 } },
    fine = { doc = "slow", set = { tile = 4, samples = 64 } },
  },
  default_preset = "fine",
  build = function(p)
    local tile = p.tile
    if p.method() == "truth" then
      local l = pipeline.loop {
        name = "shutter", count = p.samples, times = p.times, slices = 4,
        until_ = function(r) return r.done end,
        body = function()
          local a = add { time = "sample" }
          return { sum = a.sum, done = a.done }
        end,
      }
      return { color = l.sum }
    end
    local g = base {}
    local far = largest { velocity = g.velocity, id = g.id, tile = tile, as = "far", bias = 1 }
    local near = largest { velocity = far.max, as = "near", order = "rows", fast = false }
    return { color = smear { color = g.color, max = near.max }.color, depth = g.depth, max = far.max }
  end,
}
)";

class Evaluate : public ::testing::Test {
 protected:
  void SetUp() override { home_.write("scripts/pipelines/sample.lua", kPipeline); }

  plan::PipelineDesc evaluate(const Settings& sets = {}) { return evaluatePipeline(home_.home(), {"sample", sets}); }

  std::string failure(const Settings& sets) {
    try {
      evaluate(sets);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  TestHome home_;
};

static const plan::NodeDesc& nodeOf(const plan::PipelineDesc& pipeline, const std::string& name) {
  for (const plan::NodeDesc& node : pipeline.nodes) {
    if (node.name == name) return node;
  }
  throw Error("no node " + name);
}

static const plan::Binding& bindingOf(const plan::NodeDesc& node, const std::string& name) {
  for (const auto& [key, binding] : node.params) {
    if (key == name) return binding;
  }
  throw Error("no parameter " + name);
}

static Json valuesOf(const plan::PipelineDesc& pipeline) {
  Json values;
  for (const auto& [name, value] : pipeline.values) values[name] = plan::toJson(value);
  return values;
}

// A description and an error; one of the two is empty.
using Answered = std::pair<plan::PipelineDesc, std::string>;

template <class Get>
static Answered answerOf(const Get& get) {
  try {
    return {get(), ""};
  } catch (const Error& error) {
    return {{}, error.what()};
  }
}

TEST_F(Evaluate, DescribesNodesInTheOrderOfTheCalls) {
  plan::PipelineDesc p = evaluate();
  EXPECT_EQ(p.name, "sample");
  EXPECT_EQ(p.file, "scripts/pipelines/sample.lua");
  ASSERT_EQ(p.nodes.size(), 4u);
  EXPECT_EQ(p.nodes[0].name, "base");
  EXPECT_EQ(p.nodes[1].name, "far");
  EXPECT_EQ(p.nodes[2].name, "near");
  EXPECT_EQ(p.nodes[3].name, "smear");
  EXPECT_EQ(p.nodes[1].place.text(), "scripts/pipelines/sample.lua:34");
  std::vector<std::pair<std::string, std::string>> wired = {{"id", "base.id"}, {"velocity", "base.velocity"}};
  EXPECT_EQ(p.nodes[1].inputs, wired);
  std::vector<std::pair<std::string, std::string>> outputs = {
      {"color", "smear.color"}, {"depth", "base.depth"}, {"max", "far.max"}};
  EXPECT_EQ(p.outputs, outputs);
  EXPECT_EQ(p.passes.size(), 3u);
}

TEST_F(Evaluate, BindsLiteralsDefaultsAndPipelineParameters) {
  plan::PipelineDesc p = evaluate();
  const plan::NodeDesc& far = nodeOf(p, "far");
  EXPECT_EQ(bindingOf(far, "tile").follows, "tile");
  EXPECT_EQ(std::get<double>(*bindingOf(far, "bias").value), 1.0);  // an integer given for a number becomes a number
  EXPECT_EQ(std::get<std::string>(*bindingOf(far, "order").value), "columns");
  EXPECT_EQ(std::get<bool>(*bindingOf(nodeOf(p, "near"), "fast").value), false);
  EXPECT_EQ(std::get<int64_t>(*bindingOf(nodeOf(p, "near"), "tile").value), 20);
}

TEST_F(Evaluate, KeepsThePlaceOfEveryField) {
  plan::PipelineDesc p = evaluate();
  EXPECT_EQ(p.params[0].place.text(), "scripts/pipelines/sample.lua:10");
  const plan::PassDesc& largest = p.passes[1];
  EXPECT_EQ(largest.name, "largest");
  EXPECT_EQ(largest.place.text(), "passes/tile/largest.lua:2");
  EXPECT_EQ(largest.reads[0].name, "id");
  EXPECT_EQ(largest.reads[0].place.line, 7);
  EXPECT_EQ(largest.writes[0].place.line, 9);
  EXPECT_EQ(largest.params[0].place.line, 12);
  EXPECT_EQ(bindingOf(nodeOf(p, "near"), "order").place.line, 35);
}

// Writes two passes and a pipeline that share `tile`; `bias` has the same name in both passes but separate
// declarations.
static void writeShared(const TestHome& home, const std::string& tile) {
  home.write("passes/lib/blur.lua",
             "local param = require \"strobe.param\"\n"
             "return { tile = param.int { 20, min = 1, max = 99, unit = \"px\", role = \"tile\", doc = \"side\" } }\n");
  for (const char* name : {"one", "two"})
    home.write(
        fmt::format("passes/{}.lua", name),
        fmt::format("local pass = require \"strobe.pass\"\nlocal blur = require \"passes.lib.blur\"\n"
                    "return pass.raster {{\n  name = \"{0}\", shader = \"{0}\", doc = \"x\",\n"
                    "  writes = {{ color = {{ format = \"rgba16f\", doc = \"x\" }} }},\n"
                    "  params = {{ tile = {1}, bias = pass.float {{ 0.5, min = 0, max = 1, doc = \"x\" }} }},\n}}\n",
                    name, std::string(name) == "one" ? "blur.tile" : "blur.tile { 40, doc = \"y\" }"));
  home.write("scripts/pipelines/shared.lua",
             "local pipeline = require \"strobe.pipeline\"\nlocal blur = require \"passes.lib.blur\"\n"
             "local one, two = require \"passes.one\", require \"passes.two\"\n"
             "return pipeline {\n  doc = \"x\",\n  params = {\n    tile = " +
                 tile +
                 ",\n    bias = pipeline.float { 0, min = 0, max = 1, doc = \"x\" },\n  },\n"
                 "  build = function(p)\n    local far = two { bias = p.bias, tile = 7, as = \"far\" }\n"
                 "    return { color = one {}.color, near = two {}.color, far = far.color }\n  end,\n}\n");
}

TEST_F(Evaluate, NodesFollowASharedPipelineParameter) {
  writeShared(home_, "blur.tile { 30 }");
  plan::PipelineDesc p = evaluatePipeline(home_.home(), {"shared", {}});
  EXPECT_EQ(bindingOf(nodeOf(p, "one"), "tile").follows, "tile");
  EXPECT_EQ(bindingOf(nodeOf(p, "two"), "tile").follows, "tile");
  EXPECT_EQ(std::get<int64_t>(*bindingOf(nodeOf(p, "far"), "tile").value), 7) << "the call's value wins";
  EXPECT_EQ(std::get<double>(*bindingOf(nodeOf(p, "one"), "bias").value), 0.5)
      << "an equal name does not share a parameter";
  EXPECT_EQ(bindingOf(nodeOf(p, "far"), "bias").follows, "bias");
  EXPECT_EQ(valuesOf(p)["tile"], 30);
  const plan::ParamDesc* tile = plan::paramOf(p, plan::Role::Tile);
  ASSERT_NE(tile, nullptr);
  EXPECT_EQ(tile->name, "tile");
  EXPECT_EQ(tile->doc, "side");
  EXPECT_EQ(std::get<int64_t>(p.passes[1].params[1].default_value), 40) << "the pass keeps its own default";
  EXPECT_EQ(p.passes[1].params[1].doc, "y");
}

TEST_F(Evaluate, SharedParameterChangesOnlyAllowedFields) {
  auto error = [&](const std::string& tile) -> std::string {
    writeShared(home_, tile);
    try {
      evaluatePipeline(home_.home(), {"shared", {}});
    } catch (const Error& caught) {
      return caught.what();
    }
    return "none";
  };
  EXPECT_EQ(error("blur.tile { 30, unit = \"m\" }"),
            "scripts/pipelines/shared.lua:7: a change of a shared parameter has no field 'unit'");
  EXPECT_EQ(error("blur.tile { 300 }"),
            "scripts/pipelines/shared.lua:7: default of parameter 'tile' of the pipeline: 'tile' = 300 is above max 99 "
            "(range 1 to 99 px)");
  EXPECT_EQ(error("blur.tile { max = 200 }"),
            "scripts/pipelines/shared.lua:12: parameter 'tile' of pass 'one' has the range 1 to 99, but 'tile' of the "
            "pipeline "
            "has the range 1 to 200");
}

TEST_F(Evaluate, PipelinesStateTheirKindAndRegions) {
  writeShared(home_, "blur.tile");
  std::string text = readText(home_.folder() / "scripts/pipelines/shared.lua");
  text.replace(text.find("doc = \"x\""), 9,
               "doc = \"x\", kind = \"truth\", regions = { near = \"what is near\", none = \"x\" }");
  home_.write("scripts/pipelines/shared.lua", text);
  home_.write("scripts/pipelines/broken.lua", "return nil +");
  plan::PipelineDesc p = evaluatePipeline(home_.home(), {"shared", {}});
  EXPECT_EQ(p.kind, plan::PipelineDesc::Kind::Truth);
  ASSERT_EQ(p.regions.size(), 1u) << "only regions with an output in this graph";
  EXPECT_EQ(p.regions[0].name, "near");
  EXPECT_EQ(pipelineOfKind(home_.home(), plan::PipelineDesc::Kind::Truth), "shared");
  EXPECT_THROW(pipelineOfKind(home_.home(), plan::PipelineDesc::Kind::Sharp), Error);
}

TEST_F(Evaluate, PresetsAreListedWithTheirValues) {
  plan::PipelineDesc p = evaluate({{"preset", "coarse"}});
  EXPECT_EQ(p.preset, "coarse");
  ASSERT_EQ(p.presets.size(), 2u);
  EXPECT_EQ(p.presets[0].name, "coarse");
  EXPECT_FALSE(p.presets[0].is_default);
  EXPECT_EQ(p.presets[1].doc, "slow");
  EXPECT_TRUE(p.presets[1].is_default);
  EXPECT_EQ(p.presets[1].values.size(), 2u);
  EXPECT_EQ(plan::paramNamed(p, "preset"), nullptr);
}

TEST_F(Evaluate, BatchEqualsSingleEvaluations) {
  std::vector<PipelineRequest> requests = {{"sample", {}},
                                           {"sample", {{"tile", "0"}}},
                                           {"nowhere", {}},
                                           {"sample", {{"preset", "coarse"}}},
                                           {"endless", {}}};
  for (const char* name : {"sample", "counting", "broken", "endless"})
    for (int i = 0; i < 4; ++i) requests.push_back({name, {}});
  std::string counting = readText(home_.folder() / "scripts/pipelines/sample.lua");
  counting.insert(counting.find("build = function(p)") + 19, " count = count + 1 assert(count == 1) ");
  home_.write("scripts/pipelines/counting.lua", "local count = 0\n" + counting);
  home_.write("scripts/pipelines/broken.lua", "return nil +");
  home_.write("scripts/pipelines/endless.lua", "while true do end");
  Limits limits;
  limits.cpu_s = 0.3;
  auto outcomes = evaluatePipelines(home_.home(), requests, limits);
  ASSERT_EQ(outcomes.size(), requests.size());
  for (size_t i = 0; i < requests.size(); ++i) {
    const Answered alone = answerOf([&] { return evaluatePipeline(home_.home(), requests[i], nullptr, limits); });
    EXPECT_EQ(answerOf([&] { return outcomes[i].take(); }), alone);
  }
}

// Scripts stay loaded for later requests, even after a failed request, until a file changes.
TEST_F(Evaluate, RepeatedRequestsGiveEqualResults) {
  std::string text = readText(home_.folder() / "scripts/pipelines/sample.lua");
  auto loop = text;
  loop.insert(loop.find("build = function(p)") + 19, " while p.method() == \"truth\" do end ");
  home_.write("scripts/pipelines/loop.lua", loop);
  Limits limits;
  limits.cpu_s = 0.3;
  auto answers = [&](const std::vector<PipelineRequest>& requests) {
    std::vector<Answered> answers;
    for (auto& outcome : evaluatePipelines(home_.home(), requests, limits))
      answers.push_back(answerOf([&] { return outcome.take(); }));
    return answers;
  };
  const std::vector<PipelineRequest> sound = {{"sample", {}}, {"loop", {}}, {"sample", {{"preset", "coarse"}}}};
  const std::vector<Answered> first = answers(sound);
  EXPECT_EQ(first[0].first, evaluate({}));
  for (int i = 0; i < 3; ++i) {
    std::vector<Answered> stopped = answers({{"loop", {{"method", "truth"}}}, {"loop", {{"method", "truth"}}}});
    for (const auto& [pipeline, error] : stopped) EXPECT_NE(error.find("endless loop"), std::string::npos) << error;
    EXPECT_EQ(answers(sound), first);
  }
  home_.write("scripts/pipelines/sample.lua", "return 1");
  EXPECT_NE(evaluatePipelines(home_.home(), {{"sample", {}}})[0].error, nullptr);
}

TEST_F(Evaluate, RequestsOfABatchShareNoState) {
  for (const char* name : {"a", "b", "c"})
    home_.write(
        fmt::format("scripts/scenes/{}.lua", name),
        "local shared = require \"scripts.scenes.lib.count\"\nshared.n = shared.n + 1\nreturn { n = shared.n }\n");
  home_.write("scripts/scenes/lib/count.lua", "return { n = 0 }");
  for (auto& outcome : evaluateScenes(home_.home(), {"a", "b", "c", "a"}))
    EXPECT_EQ(outcome.take().dump(), R"({"n":1})");
}

TEST_F(Evaluate, LoopContainsTheNodesOfItsBody) {
  plan::PipelineDesc p = evaluate({{"method", "truth"}});
  ASSERT_EQ(p.loops.size(), 1u);
  const plan::LoopDesc& loop = p.loops[0];
  EXPECT_EQ(loop.name, "shutter");
  EXPECT_EQ(loop.count.follows, "samples");
  EXPECT_EQ(loop.times.follows, "times");
  EXPECT_EQ(std::get<int64_t>(*loop.slices.value), 4);
  EXPECT_EQ(loop.until, "add.done");
  EXPECT_EQ(p.nodes.size(), 1u);
  EXPECT_EQ(p.nodes[0].loop, "shutter");
  EXPECT_EQ(p.nodes[0].time, "sample");
  EXPECT_EQ(p.passes[0].updates[0].format, "rgba32f");
}

TEST_F(Evaluate, LoopsOverPartsHaveNoTimes) {
  auto write = [&](const std::string& more) {
    home_.write("scripts/pipelines/sample.lua", R"(local pipeline = require "strobe.pipeline"
local parts = require "strobe.parts"
local add   = require "passes.add"
return pipeline {
  doc = "parts",
  params = { steps = pipeline.int { 4, min = 1, max = 64, doc = "parts" } },
  build = function(p)
    local loop = parts.loop {
      name = "steps", count = p.steps,)" + more + R"(
      body = function() return { sum = add {}.sum } end,
    }
    return { color = loop.sum }
  end,
}
)");
  };
  write("");
  plan::PipelineDesc p = evaluate();
  ASSERT_EQ(p.loops.size(), 1u);
  EXPECT_EQ(p.loops[0].count.follows, "steps");
  EXPECT_EQ(std::get<std::string>(*p.loops[0].times.value), "parts");
  EXPECT_EQ(p.loops[0].place.line, 8);
  EXPECT_EQ(p.nodes[0].loop, "steps");
  EXPECT_TRUE(plan::hasParts(p));
  EXPECT_FALSE(plan::hasParts({}));
  write(" times = \"even\",");
  EXPECT_NE(failure({}).find("sample.lua:9: the loop of parts has no field 'times'"), std::string::npos) << failure({});
}

TEST_F(Evaluate, SetBeatsPresetBeatsDefault) {
  EXPECT_EQ(valuesOf(evaluate())["tile"], 4);
  EXPECT_EQ(valuesOf(evaluate())["samples"], 64);
  EXPECT_EQ(valuesOf(evaluate({{"preset", "coarse"}}))["tile"], 64);
  EXPECT_EQ(valuesOf(evaluate({{"preset", "coarse"}}))["samples"], 16);
  EXPECT_EQ(valuesOf(evaluate({{"preset", "coarse"}, {"tile", "8"}}))["tile"], 8);
  EXPECT_EQ(valuesOf(evaluate({{"tile", "8"}, {"preset", "coarse"}}))["tile"], 8);
  EXPECT_EQ(valuesOf(evaluate({{"tile", "8"}, {"tile", "9"}}))["tile"], 9);
  EXPECT_EQ(evaluate({{"preset", "coarse"}}).preset, "coarse");
}

TEST_F(Evaluate, NodeSettingsReplaceBindings) {
  plan::PipelineDesc p = evaluate({{"far.tile", "100"}, {"near.bias", "0.25"}, {"near.fast", "true"}});
  EXPECT_EQ(std::get<int64_t>(*bindingOf(nodeOf(p, "far"), "tile").value), 100);
  EXPECT_TRUE(bindingOf(nodeOf(p, "far"), "tile").follows.empty());
  EXPECT_EQ(std::get<double>(*bindingOf(nodeOf(p, "near"), "bias").value), 0.25);
  EXPECT_EQ(std::get<bool>(*bindingOf(nodeOf(p, "near"), "fast").value), true);
}

TEST_F(Evaluate, OnlyThePipelineSetsWiredParameters) {
  home_.write("passes/mask.lua", R"(local pass = require "strobe.pass"
return pass.compute { name = "mask", shader = "mask", doc = "x", size = "frame",
  writes = { mask = { format = "rgba16f", doc = "x" } },
  params = { is_last = pass.bool { false, wired = true, doc = "nothing comes after it" } } }
)");
  home_.write("scripts/pipelines/sample.lua", R"(local pipeline = require "strobe.pipeline"
local mask = require "passes.mask"
return pipeline { doc = "x", build = function() return { color = mask { is_last = true }.mask } end }
)");
  plan::PipelineDesc plain = evaluate();
  EXPECT_EQ(std::get<bool>(*bindingOf(nodeOf(plain, "mask"), "is_last").value), true);
  EXPECT_EQ(failure({{"mask.is_last", "false"}}),
            "--set mask.is_last=false: only the pipeline sets 'is_last' of node 'mask'");
  EXPECT_EQ(failure({{"is_last", "false"}}), "--set is_last=false: the pipeline has no parameter 'is_last'");
  EXPECT_THROW(plan::withSettings(plain, {{"mask.is_last", false}}), Error);
}

TEST_F(Evaluate, WrongSettingsAreRefusedWithTheNearestName) {
  EXPECT_EQ(failure({{"smaples", "3"}}),
            "--set smaples=3: the pipeline has no parameter 'smaples'; did you mean 'samples'?");
  EXPECT_EQ(failure({{"samples", "0"}}), "--set samples=0: 'samples' = '0' is below min 1 (range 1 to 1024)");
  EXPECT_EQ(failure({{"samples", "2.5"}}), "--set samples=2.5: 'samples' = '2.5' is not an integer");
  EXPECT_EQ(failure({{"tile", "x"}}), "--set tile=x: 'tile' = 'x' is not an integer");
  EXPECT_EQ(failure({{"method", "smaer"}}),
            "--set method=smaer: 'method' = 'smaer' is not one of smear, truth; did you mean 'smear'?");
  EXPECT_EQ(failure({{"preset", "corse"}}),
            "--set preset=corse: 'preset' = 'corse' is not one of coarse, fine; did you mean 'coarse'?");
  EXPECT_EQ(failure({{"bias", "1"}}),
            "--set bias=1: the pipeline has no parameter 'bias'; these nodes have it: 'far.bias', 'near.bias'");
  EXPECT_EQ(failure({{"far.tiel", "1"}}),
            "--set far.tiel=1: node 'far' has no parameter 'tiel'; did you mean 'far.tile'?");
  EXPECT_EQ(failure({{"fra.tile", "1"}}), "--set fra.tile=1: unknown node 'fra'; did you mean 'far.tile'?");
  EXPECT_EQ(failure({{"far.tile", "1000"}}),
            "--set far.tile=1000: node 'far': 'tile' = '1000' is above max 256 (range 1 to 256 px)");
  EXPECT_EQ(failure({{"a", "1"}, {"far.b", "1"}}),
            "--set a=1: the pipeline has no parameter 'a'\n--set far.b=1: node 'far' has no parameter 'b'");
}

TEST_F(Evaluate, ListsNamesAndRefusesUnknownOnes) {
  home_.write("scripts/pipelines/other.lua", kPipeline);
  home_.write("scripts/scenes/ball.lua", "return {}");
  EXPECT_EQ(pipelineNames(home_.home()), (std::vector<std::string>{"other", "sample"}));
  EXPECT_EQ(sceneNames(home_.home()), (std::vector<std::string>{"ball"}));
  try {
    evaluatePipeline(home_.home(), {"smaple", {}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "unknown pipeline 'smaple'; did you mean 'sample'?");
  }
  EXPECT_THROW(evaluatePipeline(home_.home(), {"nowhere/x.lua", {}}), Error);
}

TEST_F(Evaluate, NameHasOneSpelling) {
  home_.write("scripts/pipelines/of/other.lua", kPipeline);
  home_.write("scripts/pipelines/lib/part.lua", kPipeline);
  EXPECT_EQ(evaluatePipeline(home_.home(), {"of/other", {}}).name, "other");
  for (const char* name : {"of//other", "./sample", "of/../sample", "../pipelines/sample", "lib/part", "sample/", ""})
    EXPECT_THROW(evaluatePipeline(home_.home(), {name, {}}), Error) << name;
}

TEST_F(Evaluate, UserFileFindsItsNeighbours) {
  std::string own = kPipeline;
  std::string name = "require \"passes.smear\"";
  own.replace(own.find(name), name.size(), "require \"lib.mine\"");
  std::string smear = samplePasses().at("passes/smear.lua");
  home_.write("mine/own.lua", own);
  home_.write("mine/lib/mine.lua", smear.replace(smear.find("\"smear\""), 7, "\"mine\""));
  std::vector<Dependency> files;
  plan::PipelineDesc p = evaluatePipeline(home_.home(), {(home_.folder() / "mine/own.lua").string(), {}}, &files);
  EXPECT_EQ(p.name, "own");
  EXPECT_EQ(p.nodes[3].name, "mine");
  EXPECT_EQ(p.passes[2].place.text(), "mine/lib/mine.lua:2");
}

TEST_F(Evaluate, DependenciesAreReportedOnSuccessAndOnFailure) {
  std::vector<Dependency> files;
  evaluatePipeline(home_.home(), {"sample", {}}, &files);
  std::set<std::string> shown;
  for (const Dependency& file : files) {
    shown.insert(file.shown);
    EXPECT_EQ(file.hash.size(), 32u);
    EXPECT_TRUE(std::filesystem::exists(file.path)) << file.path;
  }
  EXPECT_TRUE(shown.contains("scripts/pipelines/sample.lua"));
  EXPECT_TRUE(shown.contains("passes/tile/largest.lua"));
  EXPECT_TRUE(shown.contains("scripts/strobe/pipeline.lua"));

  home_.write("passes/smear.lua", "return nil +");
  EXPECT_THROW(evaluatePipeline(home_.home(), {"sample", {}}, &files), Error);
  EXPECT_TRUE(std::any_of(files.begin(), files.end(), [](auto& file) { return file.shown == "passes/smear.lua"; }));
}

TEST_F(Evaluate, AllPassesAreSortedByName) {
  std::vector<plan::PassDesc> passes = evaluateAllPasses(home_.home());
  ASSERT_EQ(passes.size(), 4u);
  EXPECT_EQ(passes[0].name, "add");
  EXPECT_EQ(passes[3].name, "smear");

  home_.write("passes/a.lua", "local x = = 1");
  home_.write("passes/b.lua", "return 1");
  std::string smear = samplePasses().at("passes/smear.lua");
  home_.write("passes/c.lua", smear);
  try {
    evaluateAllPasses(home_.home());
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "passes/a.lua:1: unexpected symbol near '='\n"
                 "passes/b.lua: returns a number instead of a pass\n"
                 "passes/smear.lua:2: another pass is called 'smear': passes/c.lua:2");
  }
}

TEST_F(Evaluate, SceneIsPlainDataWithParameters) {
  home_.write("scripts/scenes/ball.lua",
              "local n = scene_params.count or 3\nlocal list = {}\nfor i = 1, n do list[i] = { x = i / 2 } end\n"
              "return { balls = list, name = scene_params.name or 'none', none = {}, turn = scene_params.turn }\n");
  EXPECT_EQ(evaluateScene(home_.home(), "ball", {}).dump(),
            R"({"balls":[{"x":0.5},{"x":1.0},{"x":1.5}],"name":"none","none":[]})");
  Json set = evaluateScene(home_.home(), "ball",
                           {{"scene.count", "1"}, {"tile", "3"}, {"scene.name", "a b"}, {"scene.turn", "0.1"}});
  EXPECT_EQ(set.dump(), R"({"balls":[{"x":0.5}],"name":"a b","none":[],"turn":0.1})");
  try {
    evaluateScene(home_.home(), "ball", {{"scene.cuont", "1"}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "--set scene.cuont=1: the scene has no parameter 'cuont'; did you mean 'count'?");
  }
}

TEST_F(Evaluate, SceneMayHoldPlainDataOnly) {
  auto failureOf = [&](const std::string& text) -> std::string {
    home_.write("scripts/scenes/odd.lua", text);
    try {
      evaluateScene(home_.home(), "odd", {});
    } catch (const Error& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_EQ(failureOf("return { a = { b = print } }"), "scripts/scenes/odd.lua: 'a.b' is a function, not plain data");
  EXPECT_EQ(failureOf("return { a = 1 / 0 }"), "scripts/scenes/odd.lua: 'a' is not a finite number");
  EXPECT_EQ(failureOf("return { a = { 1, x = 2 } }"),
            "scripts/scenes/odd.lua: 'a' has keys that are neither names nor 1, 2, 3 ...");
  EXPECT_EQ(failureOf("local t = {}\nt[1] = t\nreturn t").find("scripts/scenes/odd.lua: '[1]"), 0u);
  EXPECT_EQ(failureOf("return"), "scripts/scenes/odd.lua: returns nothing; it should end in 'return'");
}

TEST_F(Evaluate, DataGetsItsArguments) {
  home_.write("x/demo.lua", "local arguments = ...\nreturn { twice = arguments.n * 2, half = arguments.n / 2 }");
  Json result = evaluateData(home_.home(), (home_.folder() / "x/demo.lua").string(), {{"n", 3}});
  EXPECT_EQ(result.dump(), R"({"half":1.5,"twice":6})");
}

// ---- Preset files

// A preset file outside the folder of pipelines.
class PresetFile : public Evaluate {
 protected:
  std::string write(const std::string& table) {
    home_.write("tried/found.lua", "local preset = require \"strobe.preset\"\n\nreturn preset {\n" + table + "}\n");
    return (home_.folder() / "tried/found.lua").string();
  }
};

TEST_F(PresetFile, IsUsedLikeANamedPreset) {
  std::string file = write("  doc = \"found\",\n  set = { tile = 8, method = \"truth\" },\n");
  plan::PipelineDesc p = evaluate({{"preset", file}});
  EXPECT_EQ(p.preset, file);
  EXPECT_EQ(valuesOf(p)["tile"], 8);
  EXPECT_EQ(valuesOf(p)["samples"], 16) << "not from the default preset";
  EXPECT_EQ(p.loops.size(), 1u) << "the preset decides the graph";
  ASSERT_EQ(p.presets.size(), 3u);
  EXPECT_EQ(p.presets[2].doc, "found");
  EXPECT_EQ(valuesOf(evaluate({{"tile", "4"}, {"preset", file}}))["tile"], 4) << "a setting overrides the preset";
  EXPECT_EQ(valuesOf(evaluate({{"preset", "tried/found.lua"}}))["tile"], 8)
      << "found in the home if not in the current folder";
  Outcome<plan::PipelineDesc> one = std::move(evaluatePipelines(home_.home(), {{"sample", {{"preset", file}}}})[0]);
  EXPECT_EQ(valuesOf(one.take())["tile"], 8);
}

TEST_F(PresetFile, IsADependency) {
  std::string file = write("  doc = \"found\",\n  set = { tile = 8 },\n");
  std::vector<Dependency> dependencies;
  evaluatePipeline(home_.home(), {"sample", {{"preset", file}}}, &dependencies);
  EXPECT_TRUE(std::any_of(dependencies.begin(), dependencies.end(), [&](const Dependency& one) {
    return one.path == file && one.shown == "tried/found.lua" && one.hash == hashOfPath(file);
  }));
  Texts edited = {{file, "return require(\"strobe.preset\") { doc = \"x\", set = { tile = 2 } }"}};
  EXPECT_EQ(valuesOf(evaluatePipeline(home_.home(), {"sample", {{"preset", file}}, edited}))["tile"], 2);
}

TEST_F(PresetFile, AppliesToAPipelineWithoutPresets) {
  std::string text = kPipeline;
  size_t from = text.find("  presets = {"), to = text.find("  build =");
  home_.write("scripts/pipelines/sample.lua", text.erase(from, to - from));
  plan::PipelineDesc p = evaluate({{"preset", write("  doc = \"found\",\n  set = { tile = 8 },\n")}});
  EXPECT_EQ(valuesOf(p)["tile"], 8);
  ASSERT_EQ(p.presets.size(), 2u);
  EXPECT_EQ(p.presets[0].name, "none");
  EXPECT_TRUE(p.presets[0].is_default);
}

TEST_F(PresetFile, IsRefusedAtTheLineOfTheMistake) {
  auto refused = [&](const std::string& table) { return failure({{"preset", write(table)}}); };
  std::string named = "preset '" + (home_.folder() / "tried/found.lua").string() + "'";
  EXPECT_EQ(refused("  doc = \"x\",\n  set = {\n    tiel = 8,\n  },\n"),
            "tried/found.lua:6: " + named + " sets 'tiel', which is not a parameter; did you mean 'tile'?");
  EXPECT_EQ(refused("  doc = \"x\",\n  set = { tile = 1 },\n"),
            "tried/found.lua:5: " + named + ": 'tile' = 1 is below min 2 (range 2 to 64 px)");
  EXPECT_EQ(refused("  doc = \"x\",\n  sets = {},\n  set = {},\n"),
            "tried/found.lua:5: " + named + " has no field 'sets'; did you mean 'set'?");
  EXPECT_EQ(refused("  set = {},\n"), "tried/found.lua:3: " + named + " has no 'doc', a text that describes it");
  home_.write("tried/found.lua", "return {}\n");
  EXPECT_EQ(failure({{"preset", "tried/found.lua"}}),
            "tried/found.lua: returns a table instead of preset { ... } of strobe.preset");
  home_.write("tried/found.lua", "return 1 +\n");
  EXPECT_EQ(failure({{"preset", "tried/found.lua"}}).substr(0, 18), "tried/found.lua:2:");
  EXPECT_EQ(failure({{"preset", "tried/gone.lua"}}),
            "--set preset=tried/gone.lua: preset file 'tried/gone.lua' does not exist");
}

TEST_F(PresetFile, MissingFileIsDroppedIfAllowed) {
  std::vector<DroppedSetting> dropped;
  plan::PipelineDesc p =
      evaluatePipeline(home_.home(), {"sample", {{"preset", "tried/gone.lua"}}}, nullptr, {}, &dropped);
  ASSERT_EQ(dropped.size(), 1u);
  EXPECT_EQ(dropped[0].reason, "preset file 'tried/gone.lua' does not exist");
  EXPECT_EQ(p.preset, "fine");
}

}  // namespace evaluate_test
}  // namespace strobe::script
