// SPDX-License-Identifier: MIT
#include "live/camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace strobe::live {

static const dvec3 kUp(0, 1, 0);
static const double kSteepest = glm::radians(89.5);

// Unit direction as angles, radians. Yaw is 0 along -z and grows to the right. Pitch is the angle above the horizon.
struct ViewDirection {
  double yaw = 0, pitch = 0;
};

static ViewDirection headingOf(const dvec3& direction) {
  return {std::atan2(direction.x, -direction.z), std::asin(std::clamp(direction.y, -1.0, 1.0))};
}

static dvec3 directionOf(const ViewDirection& heading) {
  return {std::sin(heading.yaw) * std::cos(heading.pitch), std::sin(heading.pitch),
          -std::cos(heading.yaw) * std::cos(heading.pitch)};
}

static double distanceOf(const Viewpoint& view) { return glm::length(view.target - view.eye); }

static dvec3 turnedDirection(const Viewpoint& view, double yaw, double pitch) {
  ViewDirection heading = headingOf(forwardOf(view));
  heading.yaw += yaw;
  heading.pitch = std::clamp(heading.pitch + pitch, -kSteepest, kSteepest);
  return directionOf(heading);
}

Viewpoint viewpointOf(const dmat4& world_from_camera, double distance_m) {
  dvec3 eye(world_from_camera[3]);
  return {eye, eye - glm::normalize(dvec3(world_from_camera[2])) * distance_m};
}

std::string toText(const Viewpoint& view) {
  return fmt::format("{},{},{},{},{},{}", view.eye.x, view.eye.y, view.eye.z, view.target.x, view.target.y,
                     view.target.z);
}

static double rounded(double value) { return std::strtod(fmt::format("{:.7g}", value).c_str(), nullptr); }

static dvec3 rounded(const dvec3& at) { return {rounded(at.x), rounded(at.y), rounded(at.z)}; }

Viewpoint rounded(const Viewpoint& view) { return {rounded(view.eye), rounded(view.target)}; }

dvec3 forwardOf(const Viewpoint& view) { return glm::normalize(view.target - view.eye); }

dvec3 rightOf(const Viewpoint& view) {
  dvec3 right = glm::cross(forwardOf(view), kUp);
  double length = glm::length(right);
  return length > 1e-9 ? right / length : dvec3(1, 0, 0);
}

dvec3 upOf(const Viewpoint& view) { return glm::cross(rightOf(view), forwardOf(view)); }

// An eye that moves to the right round the pivot turns to the left.
Viewpoint orbited(const Viewpoint& view, const dvec3& pivot, double yaw, double pitch) {
  const Viewpoint ahead{view.eye, view.eye + turnedDirection(view, -yaw, -pitch) * distanceOf(view)};
  dvec3 from_eye = pivot - view.eye;
  dvec3 turned = rightOf(ahead) * glm::dot(from_eye, rightOf(view)) + upOf(ahead) * glm::dot(from_eye, upOf(view)) +
                 forwardOf(ahead) * glm::dot(from_eye, forwardOf(view));
  dvec3 eye = pivot - turned;
  return {eye, eye + (ahead.target - ahead.eye)};
}

dvec3 pointAt(const Viewpoint& view, const dvec2& from_middle_px, double metres_per_px, double depth_m) {
  dvec2 by = from_middle_px * metres_per_px;
  return view.eye + forwardOf(view) * depth_m + rightOf(view) * by.x - upOf(view) * by.y;
}

Viewpoint turned(const Viewpoint& view, double yaw, double pitch) {
  return {view.eye, view.eye + turnedDirection(view, yaw, pitch) * distanceOf(view)};
}

Viewpoint panned(const Viewpoint& view, double dx_px, double dy_px, double height_px, double vertical_fov) {
  double metres_per_px = 2 * std::tan(vertical_fov / 2) * distanceOf(view) / height_px;
  dvec3 by = (upOf(view) * dy_px - rightOf(view) * dx_px) * metres_per_px;
  return {view.eye + by, view.target + by};
}

Viewpoint dollied(const Viewpoint& view, double factor) {
  double distance = std::max(distanceOf(view) * factor, 1e-3);
  return {view.target - forwardOf(view) * distance, view.target};
}

Viewpoint flown(const Viewpoint& view, const dvec3& by_m) {
  dvec3 by = rightOf(view) * by_m.x + kUp * by_m.y + forwardOf(view) * by_m.z;
  return {view.eye + by, view.target + by};
}

}  // namespace strobe::live
