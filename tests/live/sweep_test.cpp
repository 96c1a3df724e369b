// SPDX-License-Identifier: MIT
// Sweeps without a window: pictures, errors and times of every value, use of values, and changes that make a sweep
// stale.
#include "live/sweep.h"

#include <limits>

#include "image/metrics.h"
#include "image/tone.h"
#include "live/sweeper.h"
#include "oracle/render.h"

namespace strobe::live {
namespace sweep_test {

class SweepTest : public oracle::RenderTest {
 protected:
  // An edge that moves by 20 px over the exposure.
  static lab::Shot shot() {
    return oracle::with(oracle::shotOf("half_plane", 48, 4, {{"edge", 24}, {"d_f", 20}}), "mcguire2012");
  }
  static DeskOptions options() {
    DeskOptions options;
    options.shot = shot();
    return options;
  }
  static lab::Control controlOf(Desk& desk, const std::string& name) {
    for (lab::Control& control : desk.a().session->controls())
      if (control.declaration.name == name) return control;
    ADD_FAILURE() << "missing control: " << name;
    return {};
  }
  static std::string valueOf(Desk& desk, const std::string& name) {
    return lab::plainText(controlOf(desk, name).value);
  }
  // Runs the window's turns until the sweep is complete.
  static void finish(Desk& desk, Sweeper& sweeper, int samples = 1) {
    for (int i = 0; i < 2000 && !(sweeper.isComplete() && sweeper.sweep().samples() >= samples); ++i) {
      desk.turn();
      sweeper.turn(desk);
    }
    ASSERT_TRUE(sweeper.isComplete());
    ASSERT_GE(sweeper.sweep().samples(), samples);
  }
};

TEST_F(SweepTest, EveryValueHasPictureErrorAndTime) {
  Desk desk(bench(), options());
  Sweeper sweeper;
  EXPECT_FALSE(sweeper.turn(desk));
  sweeper.open(desk, "samples", false, {"4", "8", "16"});
  finish(desk, sweeper, 64);
  ASSERT_EQ(sweeper.sweep().points().size(), 3u);
  for (const SweepPoint& point : sweeper.sweep().points()) {
    std::string value = lab::plainText(sweeper.sweep().axes()[0].values[point.at[0]]);
    lab::Picture alone = render(oracle::with(shot(), "mcguire2012", {"samples=" + value}));
    EXPECT_TRUE(oracle::identical(point.color, image::threeChannels(oracle::colorOf(alone)))) << value;
    double now = image::rootMeanSquaredError(point.color, desk.truth().mean());
    EXPECT_NEAR(*point.error, now, 0.1 * now) << value << ": at most a quarter of truth's samples is missing";
    EXPECT_EQ(point.ms.size(), size_t(Sweep::kRounds));
    EXPECT_GT(*point.median(), 0);
  }
  EXPECT_EQ(valueOf(desk, "samples"), "16") << "the window's shot is unchanged";
}

// The window can draw between any two frames of a sweep.
TEST_F(SweepTest, SliceIsAtLeastOneFrame) {
  GatheredTruth truth(bench(), "");
  Desk desk(bench(), options());
  SweepAxis axis = axisOf(controlOf(desk, "samples").declaration, std::vector<std::string>{"4", "8"});
  Sweep sweep(bench(), desk.shot(), {axis}, desk.shot(), "");
  EXPECT_EQ(sweep.drawn(), 0u);
  for (size_t drawn : {1u, 2u}) {
    EXPECT_TRUE(sweep.advance(truth, 0));
    EXPECT_EQ(sweep.drawn(), drawn);
  }
  EXPECT_EQ(sweep.samples(), 0) << "no truth yet";
  EXPECT_TRUE(sweep.advance(truth, 0));
  EXPECT_EQ(sweep.points()[0].ms.size(), 1u) << "times need no truth";
  EXPECT_TRUE(sweep.points()[1].ms.empty());
  sweep.stop();
  EXPECT_FALSE(sweep.advance(truth, 0));
  EXPECT_TRUE(sweep.isWhole());
}

TEST_F(SweepTest, ValuesThatChangeTruthHaveTheirOwnTruth) {
  Desk desk(bench(), options());
  Sweeper sweeper;
  sweeper.open(desk, "exposure", false, {"0.25", "1"});
  EXPECT_FALSE(sweeper.sweep().sharesTruth());
  finish(desk, sweeper, Sweep::kOwnSamples);
  for (const SweepPoint& point : sweeper.sweep().points()) {
    lab::RunningTruth truth(bench(), "", {4, 16, std::numeric_limits<double>::infinity()});
    truth.restart(point.shot);
    while (truth.samples() < Sweep::kOwnSamples) truth.step();
    EXPECT_EQ(*point.error, image::rootMeanSquaredError(point.color, truth.mean()));
  }
  EXPECT_NE(*sweeper.sweep().points()[0].error, *sweeper.sweep().points()[1].error);
  EXPECT_EQ(desk.truth().samples(desk.shot()), 0) << "the window's truth is not used";
}

TEST_F(SweepTest, TakingAValueSetsItsControl) {
  Desk desk(bench(), options());
  Sweeper sweeper;
  sweeper.open(desk, "samples", false, {"4", "8", "16"});
  EXPECT_EQ(sweeper.current(desk), 2u);
  sweeper.take(desk, 0);
  EXPECT_EQ(valueOf(desk, "samples"), "4");
  EXPECT_EQ(controlOf(desk, "samples").origin, "window");
  EXPECT_TRUE(desk.a().stale);
  EXPECT_FALSE(sweeper.isStale(desk)) << "the new value is one of the sweep's";
  sweeper.takeNext(desk, 1);
  EXPECT_EQ(valueOf(desk, "samples"), "8");
  sweeper.takeNext(desk, 7);
  EXPECT_EQ(valueOf(desk, "samples"), "16");
  desk.sides().set("samples", "5", "window");
  EXPECT_EQ(sweeper.current(desk), std::nullopt);
  EXPECT_FALSE(sweeper.isStale(desk));
}

TEST_F(SweepTest, OtherChangesMakeItStale) {
  Desk desk(bench(), options());
  Sweeper sweeper;
  sweeper.open(desk, "samples", false, {"4", "8"});
  int serial = sweeper.serial();
  desk.sides().set("exposure", "0.25", "window");
  EXPECT_TRUE(sweeper.isStale(desk));
  sweeper.begin(desk);
  EXPECT_FALSE(sweeper.isStale(desk));
  EXPECT_NE(sweeper.serial(), serial);
  EXPECT_EQ(sweeper.sweep().points()[0].shot.exposure, 0.25);
  desk.sides().usePipeline("ue4");
  EXPECT_TRUE(sweeper.isStale(desk));
  sweeper.close(desk);
  EXPECT_FALSE(sweeper.isOpen());
  EXPECT_FALSE(sweeper.busy());
}

TEST_F(SweepTest, TwoControlsGiveAGrid) {
  Desk desk(bench(), options());
  Sweeper sweeper;
  sweeper.open(desk, "samples", false, {"4", "8"});
  sweeper.cross(desk, "tile", {"10", "20", "40"});
  const Sweep& sweep = sweeper.sweep();
  ASSERT_EQ(sweep.points().size(), 6u);
  EXPECT_EQ(sweep.points()[4].at, (std::vector<size_t>{1, 1}));
  sweeper.take(desk, 4);
  EXPECT_EQ(valueOf(desk, "samples"), "8");
  EXPECT_EQ(valueOf(desk, "tile"), "20");
  EXPECT_EQ(sweeper.current(desk), 4u);
  sweeper.cross(desk, "");
  EXPECT_EQ(sweeper.sweep().points().size(), 2u);
}

// A drive file's `truth N` requests samples once and waits, while the sweep alternates with it and ends.
TEST_F(SweepTest, RequestedTruthIsCompleted) {
  Desk desk(bench(), options());
  Sweeper sweeper;
  const int asked = Sweep::kEnough + 1;
  desk.wantTruth(asked);
  sweeper.open(desk, "samples", false, {"4", "8"});
  finish(desk, sweeper);
  sweeper.close(desk);
  for (int i = 0; i < 2000 && desk.busy(); ++i) desk.turn();
  EXPECT_GE(desk.truth().samples(desk.shot()), asked);
  desk.wantTruth(0);
  EXPECT_FALSE(desk.busy());
}

TEST_F(SweepTest, RefusesInvalidSweeps) {
  Desk desk(bench(), options());
  Sweeper sweeper;
  auto messageOf = [](const std::function<void()>& step) {
    try {
      step();
    } catch (const Error& error) {
      return error.message();
    }
    return std::string();
  };
  EXPECT_EQ(messageOf([&] { sweeper.open(desk, "sampels"); }), "unknown control 'sampels'; did you mean 'samples'?");
  EXPECT_NE(messageOf([&] { sweeper.open(desk, "samples", false, {"many"}); }), "");
  EXPECT_NE(messageOf([&] { sweeper.experiment(desk); }), "");
  EXPECT_FALSE(sweeper.isOpen());
  desk.sides().usePipeline("ue4", true);
  EXPECT_NE(messageOf([&] { sweeper.open(desk, "exposure", true); }).find("sweep it in A"), std::string::npos);
  sweeper.open(desk, "samples", true, {"4", "8"});
  sweeper.take(desk, 0);
  EXPECT_EQ(valueOf(desk, "samples"), "16") << "A's";
  EXPECT_EQ(sweeper.current(desk), 0u) << "B's";
  SweepAxis unknown{controlOf(desk, "samples").declaration, false, {int64_t(1), int64_t(2)}};
  unknown.declaration.name = "sampels";
  Sweep refused(bench(), desk.shot(), {unknown}, desk.shot(), "");
  while (refused.advance(desk.truth(), 1)) continue;
  EXPECT_TRUE(refused.isWhole());
  for (const SweepPoint& point : refused.points())
    EXPECT_NE(point.problem.find("sampels"), std::string::npos) << point.problem;
  lab::Shot large = desk.shot();
  large.width = large.height = 16384;
  EXPECT_NE(messageOf([&] { Sweep(bench(), large, {unknown}, large, ""); }).find("exceed the memory of a sweep"),
            std::string::npos);
}

TEST_F(SweepTest, ThumbnailsAreBoxFiltered) {
  image::Image linear(384, 192, 3);
  for (int y = 0; y < linear.height; ++y)
    for (int x = 0; x < linear.width; x += 2) linear.at(x, y, 0) = 0.5f;
  image::Image small = reduced(linear);
  ASSERT_EQ(small.width, 192);
  ASSERT_EQ(small.height, 96);
  EXPECT_EQ(small.at(7, 5, 0), 0.25f);
  EXPECT_EQ(small.at(7, 5, 1), 0);
  image::Image tiny(4, 2, 3);
  EXPECT_EQ(reduced(tiny).width, 4) << "never enlarged";
  Desk desk(bench(), options());
  Sweeper sweeper;
  sweeper.open(desk, "samples", false, {"4", "8", "16"});
  EXPECT_TRUE(thumbnailOf(sweeper.sweep().points()[0], nullptr).empty()) << "empty before the point is drawn";
  finish(desk, sweeper);
  const SweepPoint& point = sweeper.sweep().points()[0];
  EXPECT_EQ(thumbnailOf(point, nullptr).values, point.color.values);
}

// Differences are too small to be visible in a thumbnail of the whole picture.
TEST_F(SweepTest, ThumbnailsShowTheCropWithTheLargestError) {
  Desk desk(bench(), options());
  Sweeper sweeper;
  desk.sides().set("width", "192", "window");
  desk.sides().set("height", "108", "window");
  sweeper.open(desk, "samples", false, {"1", "16"});
  finish(desk, sweeper, 64);
  const Sweep& sweep = sweeper.sweep();
  ASSERT_TRUE(sweep.worst());
  const image::Rectangle area = sweep.worst()->worst;
  EXPECT_EQ(area.width, Sweep::kCrop);
  EXPECT_EQ(area.height, 27);
  // No other crop of any point has a larger error.
  for (const SweepPoint& point : sweep.points())
    for (int y = 0; y + area.height <= point.color.height; y += 9)
      for (int x = 0; x + area.width <= point.color.width; x += 6) {
        const image::Rectangle at{x, y, area.width, area.height};
        double error = image::meanSquaredError(image::crop(point.color, at), image::crop(desk.truth().mean(), at));
        EXPECT_LE(error * 3 * area.width * area.height, 1.5 * sweep.worst()->worst_sum) << x << ", " << y;
      }
  const image::Image& color = sweep.points()[1].color;
  const image::Image thumbnail = thumbnailOf(sweep.points()[1], sweep.worst());
  for (int x : {0, 20, 47})
    EXPECT_EQ(thumbnail.at(4 * x + 1, 4 * 13 + 1, 0), color.at(area.x + x, area.y + 13, 0)) << x;
}

}  // namespace sweep_test
}  // namespace strobe::live
