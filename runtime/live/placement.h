// SPDX-License-Identifier: MIT
// Where a picture lies in the window: fitted into an area, magnified, moved. Pure.
#pragma once

#include "math/geometry.h"

namespace strobe::live {

// Left, top, width and height, pixels of the window.
struct Area {
  double x = 0, y = 0, width = 0, height = 0;
};

// How the picture is magnified: `zoom` 1 fits it; `centre` is what lies in the middle, in shares of its size.
struct Magnification {
  double zoom = 1;
  dvec2 centre = dvec2(0.5);
};

// Window = origin + scale * pixel of the picture.
struct Placement {
  dvec2 origin = dvec2(0);
  double scale = 1;
  dvec2 toWindow(const dvec2& pixel) const { return origin + pixel * scale; }
  dvec2 toPicture(const dvec2& window) const { return (window - origin) / scale; }
};

// Enlarged fitted pictures have pixels of whole size, so that all are alike.
Placement placed(const Area& area, int width, int height, const Magnification& magnification);

// `factor` times as large, and what is at `window` stays there.
Magnification magnified(const Magnification& from, double factor, const dvec2& window, const Area& area, int width,
                        int height);

// Moved by a drag in the window.
Magnification dragged(const Magnification& from, const dvec2& by_window, const Area& area, int width, int height);

}  // namespace strobe::live
