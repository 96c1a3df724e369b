// SPDX-License-Identifier: MIT
// A camera that is moved by hand: where it stands and what it looks at. Pure functions; y is up.
#pragma once

#include <array>
#include <string>

#include "math/geometry.h"

namespace strobe::live {

// Of a drag in the window: half a turn in some 500 pixels.
constexpr double kRadiansPerPixel = 0.006;

// What the option --view takes. The eye is never at the target.
struct Viewpoint {
  dvec3 eye = dvec3(0, 0, 1);
  dvec3 target = dvec3(0);
  bool operator==(const Viewpoint&) const = default;
};

// Of a camera that looks along -z of `world_from_camera`, the target `distance_m` ahead.
Viewpoint viewpointOf(const dmat4& world_from_camera, double distance_m);

// "ex,ey,ez,tx,ty,tz", as --view takes it; as short as reads back the same.
std::string toText(const Viewpoint& view);

// To seven digits, a micrometre of a few metres: a hand needs no more, and the text is short.
Viewpoint rounded(const Viewpoint& view);

dvec3 forwardOf(const Viewpoint& view);  // unit
dvec3 rightOf(const Viewpoint& view);    // unit, level
dvec3 upOf(const Viewpoint& view);       // unit

// Eye and target go round `pivot`, which stays where it is in the picture: `yaw` to the right about the vertical,
// `pitch` upwards, radians. Distances stay, and the view stays half a degree off the poles, where up and forward are
// one.
Viewpoint orbited(const Viewpoint& view, const dvec3& pivot, double yaw, double pitch);

// The point `depth_m` ahead of a camera without roll, `from_middle_px` from the middle of its picture (y down), where a
// pixel is `metres_per_px` large.
dvec3 pointAt(const Viewpoint& view, const dvec2& from_middle_px, double metres_per_px, double depth_m);

// The view turns about the eye: `yaw` to the right, `pitch` upwards, radians; same limit.
Viewpoint turned(const Viewpoint& view, double yaw, double pitch);

// Eye and target move in the plane of the picture: what is at the target's depth follows a drag of (dx, dy) pixels
// (y down) in a picture `height_px` high that shows `vertical_fov` radians.
Viewpoint panned(const Viewpoint& view, double dx_px, double dy_px, double height_px, double vertical_fov);

// The distance to the target is multiplied by `factor`, which is positive; at least a millimetre is left.
Viewpoint dollied(const Viewpoint& view, double factor);

// Eye and target move by metres: to the right, upwards (of the world) and ahead.
Viewpoint flown(const Viewpoint& view, const dvec3& right_up_ahead_m);

}  // namespace strobe::live
