// SPDX-License-Identifier: MIT
// Camera paths: properties of a cubic through keys, and the displacement of a wall.
#include "lab/camera_path.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace strobe::lab {
namespace camera_path_test {

double xAt(const std::vector<std::string>& texts, double frame) { return viewAt(cameraKeys(texts), frame)[0]; }

TEST(CameraPath, TwoKeysGiveALineThatContinues) {
  for (double frame : {-1., 0., 0.25, 2., 4., 7.})
    EXPECT_DOUBLE_EQ(xAt({"4=9,0,0,0,0,-1", "0=1,0,0,0,0,-1"}, frame), 1 + 2 * frame) << frame;
}

TEST(CameraPath, OneKeyIsStatic) { EXPECT_EQ(xAt({"3=5,0,0,0,0,-1"}, 100), 5); }

TEST(CameraPath, InterpolatesItsKeysSmoothly) {
  const std::vector<std::string> texts = {"0=0,0,0,0,0,-1", "1=1,0,0,0,0,-1", "3=0,0,0,0,0,-1", "4=5,0,0,0,0,-1"};
  const double values[] = {0, 1, 0, 5}, frames[] = {0, 1, 3, 4};
  for (int i = 0; i < 4; ++i) EXPECT_DOUBLE_EQ(xAt(texts, frames[i]), values[i]);
  const double step = 1e-6;
  for (double frame : frames) {
    double before = (xAt(texts, frame) - xAt(texts, frame - step)) / step;
    double after = (xAt(texts, frame + step) - xAt(texts, frame)) / step;
    EXPECT_NEAR(before, after, 1e-4) << frame;
  }
  // Slope at the second key: the difference of the third and first keys over three frames.
  EXPECT_NEAR((xAt(texts, 1 + step) - xAt(texts, 1 - step)) / (2 * step), 0, 1e-6);
}

TEST(CameraPath, RefusesInvalidPaths) {
  for (const char* text : {"1,2,3,0,0,0", "0=1,2,3", "x=1,2,3,0,0,0", "0=1,2,3,1,2,3", "nan=1,2,3,0,0,0", ""})
    EXPECT_THROW(cameraKeys({text}), Error) << text;
  EXPECT_THROW(cameraKeys({"1=1,2,3,0,0,0", "1=2,2,3,0,0,0"}), Error);
}

}  // namespace camera_path_test
}  // namespace strobe::lab
