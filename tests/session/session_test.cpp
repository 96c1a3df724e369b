// SPDX-License-Identifier: MIT
// A running shot: effects of changed values, pipelines and taps.
#include "common/refusal.h"
#include "common/source.h"
#include "lab/record.h"
#include "session/home.h"

namespace strobe::session {
namespace session_test {

using lab::Session;
using lab::Shot;

const lab::Control& controlOf(const std::vector<lab::Control>& controls, const std::string& name) {
  for (const auto& control : controls)
    if (control.declaration.name == name) return control;
  ADD_FAILURE() << "no control " << name;
  return controls.front();
}

std::string shownValue(const Session& session, const std::string& name) {
  return plan::toJson(controlOf(session.controls(), name).value).dump();
}

TEST_F(SessionTest, DrawsThePictureOfRender) {
  Session session(bench(), smallShot("hybrid"));
  EXPECT_EQ(hashes(session.draw()), hashes(bench().render(smallShot("hybrid")).frame));
  EXPECT_EQ(hashes(session.draw()), hashes(session.capture().frame));
}

TEST_F(SessionTest, WiredParametersHaveNoControl) {
  Session session(bench(), smallShot("hybrid"));
  int wired = 0;
  const plan::Plan& plan = session.running().plan();
  for (const plan::PlanNode& node : plan.nodes)
    for (const plan::ParamDesc& param : plan.pipeline.passes[size_t(node.pass)].params) {
      if (!param.wired) continue;
      ++wired;
      const std::string name = plan.pipeline.nodes[size_t(node.node)].name + "." + param.name;
      for (const lab::Control& control : session.controls()) EXPECT_NE(control.declaration.name, name);
    }
  EXPECT_GT(wired, 0) << "the pipeline has wired parameters";
}

TEST_F(SessionTest, ValuesCanBeSetAndReset) {
  Session session(bench(), smallShot("hybrid"));
  std::string before = colorHash(session), plan = session.running().planned().hash;
  int compiled = bench().compilations();
  session.set("samples", "5", "window");
  EXPECT_NE(colorHash(session), before);
  EXPECT_NE(session.running().planned().hash, plan);
  EXPECT_EQ(bench().compilations(), compiled) << "a number needs no compilation";
  EXPECT_EQ(controlOf(session.controls(), "samples").origin, "window");
  EXPECT_EQ(controlOf(session.controls(), "gather_raster.samples").origin, "follows samples");
  EXPECT_EQ(shownValue(session, "gather_raster.samples"), "5");
  session.unset("samples");
  EXPECT_EQ(colorHash(session), before);
  EXPECT_EQ(session.running().planned().hash, plan);
  EXPECT_EQ(controlOf(session.controls(), "samples").origin, "default");
}

TEST_F(SessionTest, PresetsCanBeChangedAndChangedBack) {
  Session session(bench(), smallShot("hybrid"));
  std::string paper = colorHash(session);
  session.set("preset", "text", "window");
  std::string text = colorHash(session);
  EXPECT_NE(text, paper);
  EXPECT_EQ(controlOf(session.controls(), "weights").origin, "preset text");
  session.set("preset", "paper", "window");
  EXPECT_EQ(colorHash(session), paper);
  int compiled = bench().compilations();
  session.set("preset", "text", "window");
  EXPECT_EQ(colorHash(session), text);
  EXPECT_EQ(bench().compilations(), compiled) << "compiled shaders are kept";
}

TEST_F(SessionTest, RefusedValuesChangeNothing) {
  Session session(bench(), smallShot("hybrid"));
  std::string before = colorHash(session), plan = session.running().planned().hash;
  auto refusal = [&](const std::string& name, const std::string& value) -> std::string {
    return testing::refusalOf([&] { session.set(name, value, "window"); });
  };
  EXPECT_NE(refusal("sample", "8").find("did you mean 'samples'"), std::string::npos) << refusal("sample", "8");
  EXPECT_NE(refusal("samples", "0").find("min"), std::string::npos) << refusal("samples", "0");
  EXPECT_NE(refusal("exposure", "-1").find("min"), std::string::npos) << refusal("exposure", "-1");
  EXPECT_NE(refusal("anchor", "clos").find("end"), std::string::npos);
  EXPECT_NE(refusal("backend", "x").find("auto"), std::string::npos);
  EXPECT_NE(refusal("size", "3").find("WIDTHxHEIGHT"), std::string::npos);
  EXPECT_NE(refusal("gather_raster.sampels", "3").find("did you mean"), std::string::npos);
  EXPECT_EQ(colorHash(session), before);
  EXPECT_EQ(session.running().planned().hash, plan);
}

TEST_F(SessionTest, TapsChangeNothing) {
  Session session(bench(), smallShot("hybrid"));
  std::map<std::string, std::string> before = hashes(session.draw());
  std::string plan = session.running().planned().hash;
  Json record = session.capture().record;
  session.tap(session.ports());
  graph::FrameResult frame = session.draw();
  EXPECT_EQ(hashes(frame), before);
  EXPECT_EQ(session.running().planned().hash, plan);
  EXPECT_EQ(session.capture().record["pipeline"], record["pipeline"]);
  EXPECT_EQ(frame.taps.size(), session.ports().size());
  EXPECT_GT(frame.taps.size(), 10u);
  std::set<std::string> wanted = {"gbuffer.depth"};
  graph::FrameResult one = session.draw(&wanted);
  EXPECT_TRUE(one.outputs.empty());
  ASSERT_EQ(one.taps.size(), 1u);
  EXPECT_EQ(lab::hashOf(one.taps.at("gbuffer.depth")), lab::hashOf(frame.taps.at("gbuffer.depth")));
  EXPECT_THROW(session.tap({"gbuffer.dept"}), Error);
  // A graph without some of the tapped images drops these taps.
  session.set("edge", "canny", "window");
  session.tap(session.ports());
  EXPECT_EQ(session.draw().taps.count("edge_thin.ridge"), 1u);
  session.set("edge", "sobel", "window");
  EXPECT_EQ(session.draw().taps.count("edge_thin.ridge"), 0u);
}

TEST_F(SessionTest, AnotherPipelineKeepsSharedValues) {
  Session session(bench(), smallShot("hybrid"));
  session.set("samples", "7", "window");
  session.set("own_edge", "true", "window");
  lab::Reload told = session.usePipeline("mcguire2012");
  EXPECT_NE(joined(told.kept).find("samples = 7"), std::string::npos);
  EXPECT_NE(joined(told.reset).find("own_edge = true: the pipeline has no parameter 'own_edge'"), std::string::npos)
      << joined(told.reset);
  EXPECT_EQ(shownValue(session, "samples"), "7");
  Shot cold = smallShot("mcguire2012");
  cold.sets.push_back({"samples", "7"});
  EXPECT_EQ(colorHash(session), lab::hashOf(bench().render(cold).frame.outputs.at("color")));
}

TEST_F(SessionTest, RecordsAndCommandLinesReproduceThePicture) {
  Shot shot = smallShot("hybrid");
  shot.sets.push_back({"samples", "9"});
  shot.view = {1, 2, 40, 0, 0, 0};
  shot.exposure = 0.3;
  Session session(bench(), shot);
  lab::Picture picture = session.capture();
  Path file = home_.path("x.record.json");
  writeFileAtomically(file, picture.record.dump());
  Session again(bench(), lab::shotFromRecord(file));
  EXPECT_EQ(again.running().planned().hash, session.running().planned().hash);
  EXPECT_EQ(hashes(again.draw()), hashes(picture.frame));
  std::string command = lab::commandOf(session.shot());
  EXPECT_NE(command.find("strobe render hybrid --scene oracles/textured_bar --size 64x36"), std::string::npos)
      << command;
  for (const char* part : {"--exposure 0.3", "--view 1,2,40,0,0,0", "--set samples=9"})
    EXPECT_NE(command.find(part), std::string::npos) << command;
}

TEST_F(SessionTest, HistoriesAreKeptFromFrameToFrame) {
  writeRunningMean(home_);
  Session session(bench(), smallShot("running_mean"));
  auto weight = [&] { return session.draw().outputs.at("sum").floats.values[3]; };
  EXPECT_EQ(weight(), 1);
  EXPECT_EQ(weight(), 2);
  session.set("weight", "2", "window");
  EXPECT_EQ(weight(), 4) << "a new value keeps the history";
  session.reload(true);
  home_.edit("shaders/test/running_mean.glsl", "1e-6", "1e-5");
  auto told = session.reload(true);
  ASSERT_TRUE(told && told->swapped);
  EXPECT_NE(joined(told->kept).find("history mean.sum"), std::string::npos) << joined(told->kept);
  EXPECT_EQ(weight(), 6) << "an edit keeps a history with the same description";
  home_.edit("passes/test/running_mean.lua", "format = \"rgba32f\", doc = \"sum;",
             "format = \"rgba16f\", doc = \"sum;");
  told = session.reload(true);
  ASSERT_TRUE(told && told->swapped) << joined(told->problems);
  EXPECT_NE(joined(told->reset).find("history mean.sum"), std::string::npos) << joined(told->reset);
  EXPECT_EQ(weight(), 2) << "a history with another description begins anew";
  // A captured picture contains a single frame, whatever was drawn before.
  EXPECT_EQ(session.capture().frame.outputs.at("sum").floats.values[3], 2);
}

// A value other than the control's; nothing for a text.
std::optional<plan::Value> otherValue(const lab::Control& control) {
  const plan::ParamDesc& declared = control.declaration;
  std::vector<plan::Value> values(declared.choices.begin(), declared.choices.end());
  if (declared.type == plan::ParamDesc::Type::Bool) values = {true, false};
  for (const auto& end : {declared.min, declared.max})
    if (end) values.push_back(declared.type == plan::ParamDesc::Type::Int ? plan::Value(int64_t(*end)) : *end);
  auto other = std::find_if(values.begin(), values.end(), [&](const auto& value) { return value != control.value; });
  return other == values.end() ? std::nullopt : std::optional(*other);
}

// Idle controls change no picture at any value. The pipeline has such controls.
TEST_F(SessionTest, IdleControlsChangeNothing) {
  Session session(bench(), smallShot("hybrid"));
  const auto before = hashes(session.draw());
  std::set<std::string> idle;
  for (const lab::Control& control : session.controls()) {
    if (control.idle.empty()) continue;
    idle.insert(control.declaration.name);
    if (auto value = otherValue(control)) session.set(control.declaration.name, *value, "test");
  }
  EXPECT_EQ(hashes(session.draw()), before);
  EXPECT_TRUE(idle.count("directions")) << "uniform weights have one direction";
  EXPECT_FALSE(idle.count("samples"));
  session.set("weights", "mcguire2012", "test");
  std::vector<lab::Control> controls = session.controls();
  std::erase_if(controls, [](const lab::Control& control) { return control.declaration.name != "directions"; });
  ASSERT_EQ(controls.size(), 1u);
  EXPECT_EQ(controls[0].idle, "");
}

}  // namespace session_test
}  // namespace strobe::session
