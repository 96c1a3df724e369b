// SPDX-License-Identifier: MIT
// Every option of a shot, converted through the table: command line, shot, record, shot, command text, shot. A new row
// is covered here once it has a value in `kGiven`.
#include <gtest/gtest.h>

#include <map>

#include "app/shot_options.h"
#include "lab/shot_options.h"

namespace strobe::lab {
namespace shot_test {

// A value of each option that differs from its default, as typed and as in a record.
struct Given {
  std::vector<std::string> texts;
  Json json;
};
const std::map<std::string, Given> kGiven = {
    {"scene", {{"oracles/bar"}, "oracles/bar"}},
    {"size", {{"160x90"}, {160, 90}}},
    {"fps", {{"29.97"}, 29.97}},
    {"frame", {{"7"}, 7}},
    {"exposure", {{"0.25"}, 0.25}},
    {"exposure_time", {{"0.02"}, 0.02}},
    {"anchor", {{"centre"}, "centre"}},
    {"shutter_curve", {{"trapezoid:0.2,0.3"}, "trapezoid:0.2,0.3"}},
    {"camera_blur", {{"0.5"}, 0.5}},
    {"object_blur", {{"0"}, 0.0}},
    {"follow", {{"bar"}, "bar"}},
    {"cuts", {{"0.5,2"}, "0.5,2"}},
    {"motion_depths", {{"1,5"}, "1,5"}},
    {"camera", {{"far away"}, "far away"}},
    {"view", {{"1,-2,40,0,0.5,0"}, {1, -2, 40, 0, 0.5, 0}}},
    {"path", {{"0=1,2,3,0,0,0", "1.5=2,2,3,0,0,0"}, {"0=1,2,3,0,0,0", "1.5=2,2,3,0,0,0"}}},
    {"allow_outside", {{"true"}, true}},
    {"animation", {{"none"}, "none"}},
    {"variant", {{"winter"}, "winter"}},
    {"faces", {{"both"}, "both"}},
    {"move", {{"bar=0.5,0,0", "ball=0,1,0"}, {"bar=0.5,0,0", "ball=0,1,0"}}},
    {"spin", {{"bar=0,1,0,3"}, Json::array({"bar=0,1,0,3"})}},
    {"rest_frame", {{"3"}, 3}},
    {"aa", {{"4"}, 4}},
    {"seed", {{"4294967295"}, 4294967295u}},
    {"backend", {{"query"}, "query"}},
    {"model_everything", {{"true"}, true}},
    {"device", {{"llvm"}, "llvm"}},
    {"tap", {{"gbuffer.depth"}, Json::array({"gbuffer.depth"})}},
};

const Given& given(const ShotOption& option) {
  auto found = kGiven.find(option.name);
  if (found == kGiven.end()) throw Error(fmt::format("no value of '{}' is tried here", option.name));
  return found->second;
}

std::vector<std::string> words(const std::string& line) {
  std::vector<std::string> list(1);
  bool quoted = false;
  for (char c : line) {
    if (c == '\'') quoted = !quoted;
    else if (c == ' ' && !quoted) list.emplace_back();
    else list.back() += c;
  }
  return list;
}

// The shot of a command line, given without "strobe render".
Shot parsed(std::vector<std::string> arguments) {
  CLI::App command;
  app::ShotOptions options;
  std::string out;
  command.add_option("-o", out);
  options.addWithPipeline(command);
  std::reverse(arguments.begin(), arguments.end());
  command.parse(arguments);
  return options.resolve();
}

Shot typed(const ShotOption& option, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments = {"hybrid"};
  for (const std::string& text : given(option).texts) {
    arguments.push_back(spelled(option));
    bool is_flag = option.fields.front().declaration.type == plan::ParamDesc::Type::Bool;
    if (!is_flag) arguments.push_back(text);
  }
  arguments.insert(arguments.end(), more.begin(), more.end());
  return parsed(arguments);
}

// The shot with the defaults that apply to a scene without suggestions.
Shot filled(Shot shot) {
  fillShot(shot, {});
  return shot;
}

Shot recorded(const Shot& shot) {
  Path file = Path(::testing::TempDir()) / "shot_test.record.json";
  writeFileAtomically(file, Json{{"shot", toJson(shot)}}.dump());
  return shotFromRecord(file);
}

Shot fromCommand(const Shot& shot) {
  std::vector<std::string> list = words(commandOf(shot));
  return parsed({list.begin() + 2, list.end()});
}

TEST(ShotOptions, RoundTripThroughCommandLineRecordAndCommandText) {
  const std::vector<std::string> sets = {"--set", "samples=7",  "--set", "scene.wide=0.5",
                                         "--set", "edge=canny", "--set", "jitter=true"};
  for (const ShotOption& option : shotOptions()) {
    SCOPED_TRACE(option.name);
    Shot shot = filled(typed(option, sets));
    EXPECT_EQ(jsonOf(option, shot), given(option).json);
    if (option.is(ShotOption::kNoPicture)) {
      EXPECT_FALSE(toJson(shot).contains(option.name));
      continue;
    }
    for (const Shot& again : {recorded(shot), fromCommand(shot), fromCommand(recorded(shot))}) {
      for (const ShotOption& other : shotOptions()) EXPECT_EQ(jsonOf(other, again), jsonOf(other, shot)) << other.name;
      EXPECT_EQ(again.sets, shot.sets);
      EXPECT_EQ(canonical(again), canonical(shot));
    }
  }
}

TEST(ShotOptions, ExperimentsSetThemByTheSameNames) {
  Json known = shotOptionsJson();
  ASSERT_EQ(known.size(), shotOptions().size());
  for (const ShotOption& option : shotOptions()) {
    Shot shot;
    setFromJson(option, shot, given(option).json);
    EXPECT_EQ(textsOf(option, shot), given(option).texts) << option.name;
  }
}

TEST(ShotOptions, IdentityDependsOnEveryOptionOfThePicture) {
  const std::vector<std::string> moved = {"--move", "bar=1,0,0"};
  Shot plain = filled(parsed({"hybrid", "--move", "bar=1,0,0"}));
  for (const ShotOption& option : shotOptions()) {
    Shot shot = filled(typed(option, option.name == "move" ? std::vector<std::string>() : moved));
    EXPECT_EQ(canonical(shot) == canonical(plain), option.is(ShotOption::kNoPicture)) << option.name;
    bool of_scene = option.concern == Concern::Scene || option.concern == Concern::Motion;
    EXPECT_EQ(sceneIdentity(shot) != sceneIdentity(plain), of_scene) << option.name;
  }
}

// If no option moves a node, fps, frame and rest frame do not change the scene.
TEST(ShotOptions, RestFrameCountsIfANodeMoves) {
  for (const char* name : {"fps", "frame", "rest_frame"})
    EXPECT_EQ(sceneIdentity(filled(typed(*findShotOption(name)))), sceneIdentity(filled(parsed({"hybrid"})))) << name;
  Shot at_rest = filled(parsed({"hybrid", "--move", "bar=1,0,0", "--frame", "5"})), same = at_rest;
  same.rest_frame = 5;
  EXPECT_EQ(canonical(at_rest), canonical(same));
}

TEST(ShotOptions, RangesFollowTheTable) {
  for (const ShotOption& option : shotOptions())
    for (const ShotField& field : option.fields) {
      if (!field.declaration.min) continue;
      for (double outside : {*field.declaration.min - 1, *field.declaration.max * 2}) {
        Shot shot = filled({});
        std::string text = fmt::format("{}", outside);
        if (option.fields.size() > 1) text += "x9";
        try {
          setFromTexts(option, shot, {text});
          ADD_FAILURE() << option.name << " took " << text;
        } catch (const Error& error) {
          EXPECT_EQ(error.exitCode(), 2);
          EXPECT_NE(std::string(error.what()).find(spelled(option)), std::string::npos) << error.what();
        }
      }
    }
}

TEST(ShotOptions, SceneSuggestionsFillUnsetOptions) {
  Shot shot;
  shot.fps = 30;
  fillShot(shot, Json::parse(R"({"shot":{"width":64,"height":40,"fps":25,"frame":3,"exposure":1}})"));
  EXPECT_EQ(toJson(shot)["size"], (Json{64, 40}));
  EXPECT_EQ(shot.fps, 30);
  EXPECT_EQ(shot.frame, 3);
  EXPECT_EQ(shot.exposure, 1);
  Shot plain = filled({});
  EXPECT_EQ(commandOf(plain),
            "strobe render '' --scene living_room --size 960x540 --fps 24 --frame 1 --exposure 0.5 --anchor end "
            "-o out.exr");
}

// An exposure in seconds does not depend on the frame rate; the exposure in frames follows from both.
TEST(ShotOptions, LaterOfExposureAndExposureTimeCounts) {
  for (double fps : {12.0, 24.0, 60.0, 144.0}) {
    const std::vector<std::string> rate = {"hybrid", "--fps", fmt::format("{}", fps), "--frame",
                                           fmt::format("{}", fps / 2)};
    std::vector<std::string> timed = rate;
    timed.insert(timed.end(), {"--exposure-time", "0.02"});
    Shot shot = filled(parsed(timed));
    EXPECT_EQ(shot.window(), (std::array<double, 2>{0.5 - 0.02, 0.5}));
    EXPECT_DOUBLE_EQ(shot.exposure, 0.02 * fps);
    Shot framed = shot;
    setFromTexts(*findShotOption("exposure"), framed, {"0.25"});
    EXPECT_DOUBLE_EQ(framed.window()[0], 0.5 - 0.25 / fps);
    setFromTexts(*findShotOption("exposure_time"), framed, {"0.02"});
    EXPECT_EQ(canonical(framed), canonical(shot));
    setFromTexts(*findShotOption("fps"), framed, {"48"});
    EXPECT_DOUBLE_EQ(framed.exposure, 0.02 * 48);
  }
  auto refusal = [](const std::vector<std::string>& arguments) -> std::string {
    try {
      filled(parsed(arguments));
    } catch (const Error& error) {
      return fmt::format("{} {}", error.exitCode(), error.what());
    }
    return "accepted";
  };
  EXPECT_EQ(refusal({"hybrid", "--exposure-time", "0.02", "--exposure", "0.5"}),
            "2 --exposure and --exposure-time exclude one another");
  EXPECT_EQ(refusal({"hybrid", "--exposure-time", "2", "--fps", "1000"}),
            "2 --exposure-time 2 is 2000 frame intervals at 1000 frames per second, above max 1000");
  EXPECT_EQ(
      refusal({"hybrid", "--shutter-curve", "trapezod"}),
      "2 --shutter-curve 'trapezod': is not one of box, triangle, trapezoid:OPENING,CLOSING, gaussian:SIGMA, weights "
      "0,1,1,0 or TIME=WEIGHT,...; did you mean 'trapezoid'?");
  EXPECT_EQ(refusal({"hybrid", "--cuts", "0.5,1.5"}), "accepted");
  EXPECT_EQ(refusal({"hybrid", "--cuts", "soon"}), "2 --cuts 'soon' is not T,T,..., a list of times in seconds");
  EXPECT_EQ(refusal({"hybrid", "--cuts", "1,"}), "2 --cuts '1,' is not T,T,..., a list of times in seconds");
  EXPECT_EQ(refusal({"hybrid", "--cuts", "1,1"}), "2 --cuts '1,1': the times do not increase");
}

TEST(Settings, AreTypedInRecords) {
  Shot shot = filled(parsed({"hybrid", "--set", "samples=7", "--set", "limit=1.0", "--set", "jitter=false", "--set",
                             "edge=canny", "--set", "name=007"}));
  EXPECT_EQ(toJson(shot)["set"].dump(), R"({"samples":7,"limit":1.0,"jitter":false,"edge":"canny","name":"007"})");
  EXPECT_EQ(recorded(shot).sets, shot.sets);
  EXPECT_EQ(fromCommand(shot).sets, shot.sets);
}

// A record from versions that wrote settings as text.
TEST(Settings, AreReadFromOldRecords) {
  Json shot = toJson(filled(parsed({"hybrid"})));
  shot["set"] = {{"samples", "7"}};
  Path file = Path(::testing::TempDir()) / "old.record.json";
  writeFileAtomically(file, Json{{"shot", shot}}.dump());
  EXPECT_EQ(canonical(shotFromRecord(file)), canonical(filled(parsed({"hybrid", "--set", "samples=7"}))));
}

TEST(Settings, LastOfANameCountsForIdentity) {
  auto identity = [](const std::vector<std::string>& arguments) { return canonical(filled(parsed(arguments))); };
  EXPECT_EQ(identity({"hybrid", "--set", "a=1", "--set", "b=2", "--set", "a=3"}),
            identity({"hybrid", "--set", "a=3", "--set", "b=2"}));
  EXPECT_EQ(identity({"hybrid", "--set", "b=2", "--set", "a=3"}), identity({"hybrid", "--set", "a=3", "--set", "b=2"}));
  EXPECT_NE(identity({"hybrid", "--set", "a=3"}), identity({"hybrid", "--set", "a=4"}));
}

}  // namespace shot_test
}  // namespace strobe::lab
