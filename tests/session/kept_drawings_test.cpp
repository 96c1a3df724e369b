// SPDX-License-Identifier: MIT
// Pictures in a row: graphs are reused, and every picture equals the picture of a new program.
#include "lab/kept_drawings.h"

#include "common/refusal.h"
#include "lab/record.h"
#include "session/home.h"

namespace strobe::session {
namespace kept_drawings_test {

using lab::KeptDrawings;
using lab::Shot;

const char* const kGather = "shaders/gather/mcguire2012.glsl";

class KeptDrawingsTest : public SessionTest {
 protected:
  static Shot shotOf(int i) {
    Shot shot = smallShot(std::vector<std::string>{"hybrid", "mcguire2012"}[size_t(i % 2)]);
    shot.exposure = 0.1 + 0.005 * i;
    shot.sets.push_back({"samples", 3 + i});
    return shot;
  }
  void expectFresh(const lab::Picture& picture, const Shot& shot, const std::string& what) {
    lab::Picture fresh = lab::Workbench(EditableHome::home(), "", true).render(shot);
    for (const auto& [part, value] : fresh.record.items())
      EXPECT_EQ(picture.record[part], value) << what << " " << part;
  }

  KeptDrawings drawings_{bench()};
};

TEST_F(KeptDrawingsTest, NewNumbersRunNoScriptAndCompileNothing) {
  for (int i = 0; i < 4; ++i) drawings_.render(shotOf(i));
  const int evaluations = bench().evaluations(), compilations = bench().compilations();
  for (int i = 4; i < 20; ++i) {
    lab::Picture picture = drawings_.render(shotOf(i));
    if (i % 5 == 0) expectFresh(picture, shotOf(i), std::to_string(i));
  }
  EXPECT_EQ(bench().evaluations(), evaluations);
  EXPECT_EQ(bench().compilations(), compilations);
}

TEST_F(KeptDrawingsTest, EditsOfEveryKindTakeEffect) {
  const Shot shot = smallShot("mcguire2012");
  lab::Picture first = drawings_.render(shot);
  expectFresh(first, shot, "first");
  const std::vector<std::array<const char*, 3>> edits = {
      {kGather, "float all = 1.0 / here.radius;", "float all = 7.0 / here.radius;"},
      {"shaders/shared/frame.h", "\n", "\n\n"},
      {"scripts/scenes/oracles/textured_bar.lua", "\n", "\n\n"},
      {"scripts/pipelines/mcguire2012.lua", "\n", "\n\n"}};
  for (const auto& [file, from, to] : edits) {
    home_.edit(file, from, to);
    expectFresh(drawings_.render(shot), shot, file);
  }
  EXPECT_NE(drawings_.render(shot).record["outputs"], first.record["outputs"]);
}

TEST_F(KeptDrawingsTest, MistakesAreRefusedAndRepairsTakeEffect) {
  const Shot shot = smallShot("mcguire2012");
  lab::Picture first = drawings_.render(shot);
  const std::string text = home_.read(kGather);
  home_.write(kGather, text + "\nmistake");
  EXPECT_NE(testing::refusalOf([&] { drawings_.render(shot); }).find(kGather), std::string::npos);
  home_.write(kGather, text);
  EXPECT_EQ(drawings_.render(shot).record.dump(), first.record.dump());
  Shot unknown = shot;
  unknown.sets.push_back({"samplse", int64_t(3)});
  EXPECT_EQ(testing::refusalOf([&] { drawings_.render(unknown); }),
            testing::refusalOf([&] { lab::Workbench(EditableHome::home(), "", true).render(unknown); }));
}

TEST_F(KeptDrawingsTest, LimitsEvictTheOldest) {
  drawings_.most = 1;
  for (int i = 0; i < 4; ++i) expectFresh(drawings_.render(shotOf(i)), shotOf(i), std::to_string(i));
}

}  // namespace kept_drawings_test
}  // namespace strobe::session
