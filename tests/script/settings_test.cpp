// SPDX-License-Identifier: MIT
// Settings applied to a description without its scripts give the values that the scripts give.
#include "plan/settings.h"

#include <gtest/gtest.h>

#include "common/home.h"
#include "script/evaluate.h"

namespace strobe::script {
namespace settings_test {

using plan::ParamDesc;

// The middle of the range, or another choice.
plan::Value otherValue(const ParamDesc& param) {
  if (param.type == ParamDesc::Type::Bool) return !std::get<bool>(param.default_value);
  if (param.type == ParamDesc::Type::Choice) return param.choices.back();
  double middle = (param.min.value_or(0) + param.max.value_or(8)) / 2;
  if (param.type == ParamDesc::Type::Int) return int64_t(middle);
  return middle;
}

// A new value for every parameter, of the pipeline and its nodes, that does not change the graph.
Settings others(const plan::PipelineDesc& pipeline) {
  Settings sets;
  for (const ParamDesc& param : pipeline.params)
    if (!plan::decidesGraph(pipeline, param.name)) sets.push_back({param.name, otherValue(param)});
  for (const plan::NodeDesc& node : pipeline.nodes)
    for (const plan::PassDesc& pass : pipeline.passes)
      for (const ParamDesc& param : pass.params)
        if (pass.name == node.pass && !param.wired) sets.push_back({node.name + "." + param.name, otherValue(param)});
  return sets;
}

TEST(Settings, EqualTheScriptsResult) {
  size_t tried = 0;
  for (const std::string& name : pipelineNames(home())) {
    SCOPED_TRACE(name);
    plan::PipelineDesc plain = evaluatePipeline(home(), {name, {}});
    Settings sets = others(plain);
    tried += sets.size();
    EXPECT_EQ(plan::withSettings(plain, sets), evaluatePipeline(home(), {name, sets}));
  }
  EXPECT_GT(tried, 50u);
}

TEST(Settings, ThatDecideTheGraphAreRecognised) {
  plan::PipelineDesc hybrid = evaluatePipeline(home(), {"hybrid", {}});
  for (const char* name : {"preset", "edge"}) EXPECT_TRUE(plan::decidesGraph(hybrid, name)) << name;
  for (const char* name : {"tile", "limit", "gbuffer.x"}) EXPECT_FALSE(plan::decidesGraph(hybrid, name)) << name;
}

TEST(Settings, WrongSettingsAreRefused) {
  plan::PipelineDesc hybrid = evaluatePipeline(home(), {"hybrid", {}});
  for (const Setting& wrong : Settings{{"samples", 0}, {"samples", "many"}, {"sampels", 3}, {"nodule.x", 1}})
    EXPECT_THROW(plan::withSettings(hybrid, {wrong}), Error) << wrong.first;
}

TEST(Settings, AreParsedFromText) {
  auto value = [](const char* text) { return settingFromText(std::string("x=") + text).second; };
  EXPECT_EQ(value("8"), plan::Value(int64_t{8}));
  EXPECT_EQ(value("8.0"), plan::Value(8.0));
  EXPECT_EQ(value("1e-3"), plan::Value(0.001));
  EXPECT_EQ(value("true"), plan::Value(true));
  for (const char* text : {"", "canny", "007", "8px", "nan", "inf", "a=b", "+5"})
    EXPECT_EQ(value(text), plan::Value(text));
  for (const char* text : {"8", "8.0", "0.001", "-2.5", "true", "007", "canny"})
    EXPECT_EQ(plan::textOf(value(text)), text);
  EXPECT_THROW(settingFromText("x"), Error);
  EXPECT_THROW(settingFromText("=x"), Error);
}

}  // namespace settings_test
}  // namespace strobe::script
