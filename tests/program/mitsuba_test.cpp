// SPDX-License-Identifier: MIT
// `strobe render --export-mitsuba`, and ground truth compared with Cycles, which draws the exported shot.
#include <gtest/gtest.h>

#include "common/source.h"
#include "image/exr.h"
#include "image/metrics.h"
#include "program/run.h"

namespace strobe::testing {
namespace mitsuba_test {

const std::string kBar =
    " --scene oracles/bar --size 64x32 --set scene.width=64 --set scene.left=20.4 --set scene.right=41.6 ";

TEST(Mitsuba, IsWrittenWithoutPictureOrDevice) {
  TemporaryFolder folder;
  const std::string into = folder / "bar";
  Outcome outcome = run("render ground_truth" + kBar + "--device none --export-mitsuba " + into);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.out, fmt::format("{0}/mesh_0_0.ply\n{0}/mesh_1_0.ply\n{0}/scene.xml\n", into));
  EXPECT_EQ(size_t(std::distance(fs::directory_iterator(into), {})), 3);
}

TEST(Mitsuba, WarnsOfOmittedFeatures) {
  TemporaryFolder folder;
  Outcome outcome = run("render none" + kBar + "--shutter-curve triangle --export-mitsuba " + folder.path().string());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("--export-mitsuba leaves out: the shutter curve"), std::string::npos) << outcome.err;
  Outcome refused = run("render none" + kBar + "--export-mitsuba " + (folder / "scene.xml"));
  EXPECT_EQ(refused.exit_code, 2);
}

image::Image colorOf(const std::string& file) { return image::colourOf(image::readExr(file), "", file); }

TEST(Mitsuba, CyclesDrawsTheSamePicture) {
  if (runLine("command -v blender").exit_code != 0) GTEST_SKIP() << "no Blender (package blender)";
  TemporaryFolder folder;
  const std::string truth = folder / "truth.exr", none = folder / "none.exr", cycles = folder / "cycles.exr";
  ASSERT_EQ(run("render none" + kBar + "-o " + none).exit_code, 0);
  Outcome drawn = run("render ground_truth" + kBar + "--samples 256 --set pixel=box --export-mitsuba " +
                      (folder / "bar") + " -o " + truth);
  ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
  const std::string script = (sourceFolder() / "tools/cycles/render.py").string();
  Outcome outcome =
      runLine(fmt::format("blender -b -noaudio -P '{}' -- '{}' '{}' 256", script, folder / "bar", cycles));
  ASSERT_TRUE(fs::exists(cycles)) << outcome.out << outcome.err;
  const double blur = image::rootMeanSquaredError(colorOf(none), colorOf(truth));
  // A pixel of the ramps has a standard deviation of at most .5 / sqrt(256) in each picture.
  EXPECT_LT(image::rootMeanSquaredError(colorOf(cycles), colorOf(truth)), 0.05 * blur);
}

}  // namespace mitsuba_test
}  // namespace strobe::testing
