// SPDX-License-Identifier: MIT
// The text of a saved sweep. program/live_test.cpp runs it.
#include "live/sweep_file.h"

#include <gtest/gtest.h>

namespace strobe::live {
namespace sweep_file_test {

SweepAxis axis(const std::string& name, plan::ParamDesc::Type type, std::vector<plan::Value> values) {
  SweepAxis axis;
  axis.declaration.name = name;
  axis.declaration.type = type;
  axis.values = std::move(values);
  return axis;
}

SavedSweep sample() {
  SavedSweep sweep;
  sweep.shot.scene = "folder/a scene.lua";
  sweep.shot.pipeline = "gather";
  sweep.shot.width = 64, sweep.shot.height = 36;
  sweep.shot.frame = 3, sweep.shot.fps = 24, sweep.shot.exposure = 0.5;
  sweep.shot.sets = {{"scene.speed", 2.0}, {"samples", int64_t(8)}, {"edge.reach", 0.25}, {"kind", std::string("far")}};
  sweep.suggested = sweep.shot;
  sweep.suggested.frame = 1;
  sweep.axes = {axis("samples", plan::ParamDesc::Type::Int, {int64_t(4), int64_t(8)})};
  sweep.axes[0].declaration.unit = "px";
  sweep.truth = "ground";
  sweep.truth_sets = {{"count", int64_t(64)}};
  return sweep;
}

void expectLine(const SavedSweep& sweep, const std::string& line) {
  std::string text = experimentText(sweep);
  EXPECT_NE(text.find(line), std::string::npos) << line << "\nin\n" << text;
}

TEST(SweepFile, HasNonDefaultsAndTheAxis) {
  SavedSweep sweep = sample();
  expectLine(sweep, "title    = \"samples of gather\"");
  expectLine(sweep, "size     = { 64, 36 }");
  expectLine(sweep, "{ name = \"a scene\", scene = \"folder/a scene.lua\", frame = 3, [\"scene.speed\"] = 2.0 }");
  expectLine(sweep, "pipeline = \"gather\", set = { [\"edge.reach\"] = 0.25, kind = \"far\" }");
  expectLine(sweep, "truth    = { pipeline = \"ground\", set = { count = 64 } }");
  expectLine(sweep, "{ name = \"samples\", unit = \"px\", scale = \"linear\", values = { 4, 8 } }");
  expectLine(sweep, "regions  = { \"whole\" }");
}

TEST(SweepFile, HasMovesAndViews) {
  SavedSweep sweep = sample();
  sweep.shot.moves = {"card=0.6,0,-1"};
  sweep.shot.spins = {"a wheel=0,1,0,30"};
  sweep.shot.view = {{0, 1, 2, 0, 0, 0}};
  expectLine(sweep, "view = { 0.0, 1.0, 2.0, 0.0, 0.0, 0.0 }");
  expectLine(sweep, "move = { card = { 0.6, 0, -1 } }, spin = { [\"a wheel\"] = { 0, 1, 0, 30 } }");
}

TEST(SweepFile, HasAxesThatAreNotParameters) {
  SavedSweep sweep = sample();
  sweep.regions = true;
  sweep.axes = {axis("exposure", plan::ParamDesc::Type::Float, {1.0, 0.5}),
                axis("width", plan::ParamDesc::Type::Int, {int64_t(32), int64_t(64)})};
  sweep.axes[1].logarithmic = true;
  expectLine(sweep, "\"exposure and width of gather\"");
  expectLine(sweep, "experiment.list { name = \"exposure\", values = { 1.0, 0.5 } },");
  expectLine(sweep, "scale = \"log\", values = { 32, 64 }, at = function(value) return { size = { value, 36 } } end }");
  expectLine(sweep, "samples = 8");
  expectLine(sweep, "\"whole\", \"inner\", \"outer\"");
  sweep.axes = {axis("kind", plan::ParamDesc::Type::Choice, {std::string("near"), std::string("far")})};
  expectLine(sweep, "{ name = \"kind\", values = { \"near\", \"far\" } }");
}

}  // namespace sweep_file_test
}  // namespace strobe::live
