// SPDX-License-Identifier: MIT
// Placement of the picture in the window: fits, zooms about the pointer, follows a drag.
#include "live/placement.h"

#include <gtest/gtest.h>

namespace strobe::live {
namespace placement_test {

const WindowArea kArea{100, 50, 800, 600};

TEST(PicturePlacement, FittedPictureFillsOneSideAndIsCentred) {
  PicturePlacement wide = placed(kArea, 1600, 400, {});
  EXPECT_DOUBLE_EQ(wide.scale, 0.5);
  EXPECT_EQ(wide.toWindow({0, 0}), dvec2(100, 250));
  EXPECT_EQ(wide.toWindow({1600, 400}), dvec2(900, 450));
}

TEST(PicturePlacement, EnlargedPixelsHaveEqualSize) {
  PicturePlacement place = placed(kArea, 320, 180, {});
  EXPECT_DOUBLE_EQ(place.scale, 2);
  EXPECT_EQ(place.toWindow({160, 90}), dvec2(500, 350));
}

TEST(PicturePlacement, WindowAndPictureAreInverse) {
  PicturePlacement place = placed(kArea, 320, 180, {3.7, {0.2, 0.8}});
  dvec2 back = place.toPicture(place.toWindow({12.5, 170.25}));
  EXPECT_NEAR(back.x, 12.5, 1e-12);
  EXPECT_NEAR(back.y, 170.25, 1e-12);
}

TEST(PicturePlacement, ZoomKeepsThePointUnderThePointer) {
  Magnification from{1.5, {0.4, 0.6}};
  dvec2 pointer(300, 500);
  dvec2 pixel = placed(kArea, 320, 180, from).toPicture(pointer);
  Magnification to = magnified(from, 4, pointer, kArea, 320, 180);
  EXPECT_DOUBLE_EQ(to.zoom, 6);
  dvec2 after = placed(kArea, 320, 180, to).toPicture(pointer);
  // Origins are rounded to window pixels: an error of half a window pixel, at 3 and 12 window pixels per picture pixel.
  EXPECT_NEAR(after.x, pixel.x, 0.5 / 3 + 0.5 / 12);
  EXPECT_NEAR(after.y, pixel.y, 0.5 / 3 + 0.5 / 12);
}

TEST(PicturePlacement, DragMovesByItsLength) {
  Magnification from{2, {0.5, 0.5}};
  PicturePlacement before = placed(kArea, 320, 180, from);
  PicturePlacement after = placed(kArea, 320, 180, dragged(from, {17, -9}, kArea, 320, 180));
  EXPECT_EQ(after.origin - before.origin, dvec2(17, -9));
}

TEST(PicturePlacement, ZoomIsLimited) {
  EXPECT_DOUBLE_EQ(magnified({}, 1e9, {500, 350}, kArea, 320, 180).zoom, 256);
  EXPECT_DOUBLE_EQ(magnified({}, 1e-9, {500, 350}, kArea, 320, 180).zoom, 0.25);
}

}  // namespace placement_test
}  // namespace strobe::live
