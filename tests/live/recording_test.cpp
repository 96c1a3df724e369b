// SPDX-License-Identifier: MIT
// States of the window that become moments, and the script made from moments. program/live_test.cpp runs the script.
#include <gtest/gtest.h>

#include "live/capture_text.h"

namespace strobe::live {
namespace recording_test {

Moment moment(int frame = 0) {
  Moment moment;
  lab::Shot& shot = moment.shots.emplace_back();
  shot.scene = "oracles/bar", shot.pipeline = "gather";
  shot.width = 64, shot.height = 36, shot.fps = 24, shot.frame = frame, shot.exposure = 0.5;
  return moment;
}

Moment with(const std::string& name, const plan::Value& value, Moment moment = recording_test::moment()) {
  lab::putSetting(moment.shots[0].sets, name, value);
  return moment;
}

Moment at(double x, Moment moment = recording_test::moment()) {
  for (lab::Shot& shot : moment.shots) shot.view = {{x, 0, 2, 0, 0, 0}};
  return moment;
}

TEST(Moments, RepeatedStateIsOneMoment) {
  Moments moments;
  for (int i = 0; i < 3; ++i) moments.add(moment());
  EXPECT_EQ(moments.all().size(), 1u);
}

TEST(Moments, DraggedValueIsOneMomentAndTypedValueAnother) {
  Moments moments;
  moments.add(moment());
  for (int value : {3, 5, 8}) {
    Moment dragged = with("samples", int64_t(value));
    dragged.goes_on = true;
    moments.add(dragged);
  }
  moments.add(with("samples", int64_t(8)));  // released
  ASSERT_EQ(moments.all().size(), 2u);
  EXPECT_EQ(std::get<int64_t>(moments.all()[1].shots[0].sets[0].second), 8);
  EXPECT_EQ(moments.all()[1].changed, std::vector<std::string>{"samples"});
  moments.add(with("samples", int64_t(16)));
  EXPECT_EQ(moments.all().size(), 3u);
}

TEST(Moments, FlightIsOneMomentAndReturnRemovesIt) {
  Moments moments;
  moments.add(moment());
  for (double x : {0.1, 0.2, 0.3}) moments.add(at(x));
  ASSERT_EQ(moments.all().size(), 2u);
  EXPECT_EQ((*moments.all()[1].shots[0].view)[0], 0.3);
  moments.add(moment());
  EXPECT_EQ(moments.all().size(), 1u) << "camera is back at its start";
  moments.add(at(0.1));
  moments.markSaved();
  moments.add(at(0.2));
  EXPECT_EQ(moments.all().size(), 3u) << "saved moments stay";
}

TEST(Moments, PlayedFramesAreASequence) {
  Moments moments;
  moments.add(with("samples", int64_t(3), moment(2)));
  for (int frame : {3, 4, 5, 2, 3}) {
    Moment played = with("samples", int64_t(3), moment(frame));
    played.goes_on = true;
    moments.add(played);
  }
  ASSERT_EQ(moments.all().size(), 1u);
  EXPECT_EQ(moments.all()[0].first_frame, 2);
  EXPECT_EQ(moments.all()[0].shots[0].frame, 5);
  moments.add(with("samples", int64_t(3), moment(3)));
  ASSERT_EQ(moments.all().size(), 2u) << "the frame after playing is a moment";
  EXPECT_EQ(moments.all()[1].first_frame, 3);
}

Recorded recordedOf(const std::vector<Moment>& states) {
  Moments moments;
  for (const Moment& state : states) moments.add(state);
  Recorded recorded{moments.all(), {}, {""}};
  lab::Shot suggested = moment().shots[0];
  for (size_t files : {0, 1}) recorded.suggested[sceneKey(files, suggested)] = suggested;
  return recorded;
}

void expectIn(const std::string& text, const std::string& line) {
  EXPECT_NE(text.find(line), std::string::npos) << line << "\nin\n" << text;
}

TEST(CaptureText, HasEachShotAndEachArmOnce) {
  Moment compared = with("samples", int64_t(8));
  compared.shots.push_back(compared.shots[0]);
  compared.shots[1].pipeline = "other/way.lua";
  compared.shots[1].sets.clear();
  std::string text = captureText(recordedOf({moment(), with("samples", int64_t(8)), compared, at(1, compared)}));
  expectIn(text, "{ name = \"view\", scene = \"oracles/bar\" }");
  expectIn(text, "{ name = \"view_2\", scene = \"oracles/bar\", view = { 1.0, 0.0, 2.0, 0.0, 0.0, 0.0 } }");
  expectIn(text, "{ name = \"gather\", pipeline = \"gather\", shots = { \"view\" } }");
  expectIn(text,
           "{ name = \"gather_2\", pipeline = \"gather\", set = { samples = 8 }, shots = { \"view\", \"view_2\" } }");
  expectIn(text, "{ name = \"way\", pipeline = \"other/way.lua\", shots = { \"view\", \"view_2\" } }");
  expectIn(text, "caption = \"gather_2: samples = 8\"");
}

TEST(CaptureText, HasSequencesAndVersionsOfFiles) {
  Moment edited = moment(3);
  edited.files = 1;
  Recorded recorded = recordedOf({moment(0), moment(1), moment(2), moment(3), edited});
  recorded.folders = {"it/files_1", "it/files_2"};
  std::string text = captureText(recorded);
  expectIn(text, "frames = { 0, 3, 1 }");
  expectIn(text, "{ name = \"view_2\", scene = \"oracles/bar\", frame = 3 }");
  expectIn(text, "files = \"it/files_1\", shots = { \"view\" }");
  expectIn(text, "files = \"it/files_2\", shots = { \"view_2\" }");
  expectIn(text, "step = 3");
}

// A shot leaves out values that its scene suggests; each version of the files may suggest other values.
TEST(CaptureText, LeavesOutSuggestionsOfTheScenesVersion) {
  Moment before = moment(), after = moment();
  before.shots[0].exposure = 0.75, after.shots[0].exposure = 0.75, after.files = 1;
  Recorded recorded = recordedOf({before, after});
  recorded.suggested[sceneKey(1, moment().shots[0])].exposure = 0.75;
  recorded.folders = {"it/files_1", "it/files_2"};
  std::string text = captureText(recorded);
  expectIn(text, "{ name = \"view\", scene = \"oracles/bar\", exposure = 0.75 }");
  expectIn(text, "{ name = \"view_2\", scene = \"oracles/bar\" }");
  expectIn(text, "files = \"it/files_2\", shots = { \"view_2\" }");
}

TEST(CaptureText, ShowsSavedMomentsOrAll) {
  std::vector<Moment> states = {moment(), with("samples", int64_t(8)), with("samples", int64_t(9))};
  std::string all = captureText(recordedOf(states));
  expectIn(all, "row = 1, column = 3");
  states[1].saved = true;
  std::string saved = captureText(recordedOf(states));
  expectIn(saved, "row = 1, column = 1, shot = \"view\", arm = \"gather_2\"");
  EXPECT_EQ(saved.find("column = 2"), std::string::npos) << saved;
}

}  // namespace recording_test
}  // namespace strobe::live
