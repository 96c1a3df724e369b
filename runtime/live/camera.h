// SPDX-License-Identifier: MIT
// Camera moved by hand: viewpoints and their changes. Pure functions; y is up.
#pragma once

#include <array>
#include <string>

#include "math/geometry.h"

namespace strobe::live {

// Rotation of a drag in the window: about half a turn in 500 pixels.
constexpr double kRadiansPerPixel = 0.006;

// Value of the option --view, world space, metres. The eye is never at the target.
struct Viewpoint {
  dvec3 eye = dvec3(0, 0, 1);
  dvec3 target = dvec3(0);
  bool operator==(const Viewpoint&) const = default;
};

// Viewpoint of a camera that looks along -z of `world_from_camera`, with the target `distance_m` ahead.
Viewpoint viewpointOf(const dmat4& world_from_camera, double distance_m);

// Text for --view: "ex,ey,ez,tx,ty,tz". The shortest text that is read back as the same numbers.
std::string toText(const Viewpoint& view);

// Rounded to seven significant digits, a micrometre at a few metres. Keeps the text short.
Viewpoint rounded(const Viewpoint& view);

dvec3 forwardOf(const Viewpoint& view);  // unit
dvec3 rightOf(const Viewpoint& view);    // unit, horizontal
dvec3 upOf(const Viewpoint& view);       // unit

// Rotates eye and target about `pivot`, radians: `yaw` about the vertical to the right, `pitch` upwards. The pivot
// keeps its place in the picture, and all distances stay. The view stays half a degree away from the poles, where
// forward and up would coincide.
Viewpoint orbited(const Viewpoint& view, const dvec3& pivot, double yaw, double pitch);

// Point `depth_m` ahead of a camera without roll, `from_middle_px` (y down) from the middle of the picture. A pixel is
// `metres_per_px` wide at that depth.
dvec3 pointAt(const Viewpoint& view, const dvec2& from_middle_px, double metres_per_px, double depth_m);

// Rotates the view about the eye, radians: `yaw` to the right, `pitch` upwards. Same limit at the poles.
Viewpoint turned(const Viewpoint& view, double yaw, double pitch);

// Moves eye and target parallel to the picture plane. A point at the target's depth follows a drag of (`dx_px`,
// `dy_px`) pixels, y down, in a picture of `height_px` pixels and `vertical_fov` radians.
Viewpoint panned(const Viewpoint& view, double dx_px, double dy_px, double height_px, double vertical_fov);

// Multiplies the distance to the target by `factor` > 0; at least 1 mm remains.
Viewpoint dollied(const Viewpoint& view, double factor);

// Moves eye and target by metres: to the right, up along the world's y axis, and ahead.
Viewpoint flown(const Viewpoint& view, const dvec3& right_up_ahead_m);

}  // namespace strobe::live
