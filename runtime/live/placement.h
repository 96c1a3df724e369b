// SPDX-License-Identifier: MIT
// Placement of a picture in the window: fitted to an area, magnified, moved. Pure functions.
#pragma once

#include "math/geometry.h"

namespace strobe::live {

// Left, top, width and height, pixels of the window.
struct WindowArea {
  double x = 0, y = 0, width = 0, height = 0;
};

// Magnification of the picture. `zoom`: 1 fits the picture into its area. `centre`: point of the picture in the middle
// of the area, as a fraction of the picture's size.
struct Magnification {
  double zoom = 1;
  dvec2 centre = dvec2(0.5);
};

// Place of the picture in the window: window position = origin + scale * pixel of the picture.
struct PicturePlacement {
  dvec2 origin = dvec2(0);
  double scale = 1;
  dvec2 toWindow(const dvec2& pixel) const { return origin + pixel * scale; }
  dvec2 toPicture(const dvec2& window) const { return (window - origin) / scale; }
};

// Placement of a picture. A fitted scale of 2 or more is rounded down to a whole number, so that all pixels have equal
// size.
PicturePlacement placed(const WindowArea& area, int width, int height, const Magnification& magnification);

// Multiplies the zoom by `factor`. The point at `window` stays in place.
Magnification magnified(const Magnification& from, double factor, const dvec2& window, const WindowArea& area,
                        int width, int height);

// Moves the picture by a drag of `by_window` pixels.
Magnification dragged(const Magnification& from, const dvec2& by_window, const WindowArea& area, int width, int height);

}  // namespace strobe::live
