// SPDX-License-Identifier: MIT
#include "scene/screen_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

#include "scene/bend.h"
#include "scene/motion.h"

namespace strobe::scene {

namespace {

constexpr int kTimes = 33;
constexpr double kTolerancePx = 0.05;
// Limit of vertices for the test of static objects. In larger scenes the test would take longer than it may save.
constexpr size_t kMostFollowed = 200'000;

// World position in the picture: (x, y) / z in px from the middle, y down; z is the depth, or 1 for an orthographic
// camera; w is the depth. A mean of points at one time is the same mean of these points at any time.
using Homogeneous = dvec4;

struct View {
  dmat4 camera_from_world;
  Camera camera;
  double height_px = 0;

  View(const Pose& pose, double height)
      : camera_from_world(glm::inverse(pose.world_from_camera)), camera(pose.camera), height_px(height) {}

  // Nothing if the position is not clearly in front of the camera.
  std::optional<Homogeneous> of(const dvec3& position_ws) const {
    const dvec3 p(camera_from_world * dvec4(position_ws, 1));
    if (!camera.orthographic && -p.z < 2 * camera.near) return std::nullopt;
    double half_height = camera.orthographic ? camera.half_height : std::tan(camera.vertical_fov / 2);
    double pixels = height_px / (2 * half_height);
    return Homogeneous(p.x * pixels, -p.y * pixels, camera.orthographic ? 1 : -p.z, -p.z);
  }
};

dvec2 pixelOf(const Homogeneous& h) { return dvec2(h) / h.z; }

// Corners of a box, and the corners at each time.
using Corners = std::array<Homogeneous, 8>;
using Track8 = std::vector<Corners>;

// Bounds of an instance in the picture, px from the middle, and its depths.
struct Extent {
  dvec2 low{INFINITY}, high{-INFINITY};
  double least_z = INFINITY;
  double nearest = INFINITY, farthest = -INFINITY;  // depths

  void add(const Corners& corners) {
    for (const Homogeneous& h : corners) {
      add(pixelOf(h));
      least_z = std::min(least_z, h.z);
      nearest = std::min(nearest, h.w);
      farthest = std::max(farthest, h.w);
    }
  }
  void add(const dvec2& pixel) {
    low = glm::min(low, pixel);
    high = glm::max(high, pixel);
  }
  // Largest distance from the middle of the picture, px.
  double most() const { return glm::length(glm::max(glm::abs(low), glm::abs(high))); }
};

// Largest distance in the picture between two positions that differ by `by` and lie within the extent, px.
double apart(const Homogeneous& by, const Extent& extent) {
  return (glm::length(dvec2(by)) + extent.most() * std::abs(by.z)) / extent.least_z;
}

// Largest distance of a point of a box from uniform straight motion between the first and the last time, px. A point in
// uniform straight motion between two places (x, y, z) is on the line between its ends in the picture. It is ahead or
// behind on this line by at most a quarter of the relative change of its depth.
double bentBy(const Track8& box, const std::vector<double>& times, const Extent& extent) {
  double bent = 0, change = 0;
  const Corners &first = box.front(), &last = box.back();
  for (size_t c = 0; c < 8; ++c)
    change = std::max({change, std::abs(last[c].z / first[c].z - 1), std::abs(first[c].z / last[c].z - 1)});
  for (size_t k = 0; k < times.size(); ++k) {
    double part = (times[k] - times.front()) / (times.back() - times.front());
    for (size_t c = 0; c < 8; ++c) bent = std::max(bent, apart(box[k][c] - glm::mix(first[c], last[c], part), extent));
  }
  return bent + 0.25 * change * glm::length(extent.high - extent.low);
}

// Largest distance of a point of a box, at the last time, from the motion of the first corner of the box, px.
double turnedBy(const Track8& box, const Extent& extent) {
  const Corners &first = box.front(), &last = box.back();
  const dvec2 moved = pixelOf(last[0]) - pixelOf(first[0]);
  double turned = 0;
  for (size_t c = 0; c < 8; ++c)
    turned = std::max(turned, apart(last[c] - first[c] - dvec4(first[c].z * moved, 0, 0), extent));
  return turned;
}

}  // namespace

// True if poses at these times show all motion. Turns of more than a right angle between two times are not shown; the
// poses may even be equal.
static bool isFollowed(const Scene& scene, double from_s, double to_s, double step_s) {
  for (const ConstantMotion& motion : scene.motions)
    if (std::abs(motion.angular_velocity) * step_s > 1.57) return false;
  for (const Animation& clip : scene.animations) {
    if (beginsAgain(clip, from_s, to_s)) return false;
    double first_s = clipTime(from_s, clip.duration), last_s = clipTime(to_s, clip.duration);
    // True if there are fewer than two poses per key of a node. Neighbouring keys differ by half a turn at most.
    auto is_dense = [&](const Track& track) {
      if (!track.isOfNode()) return false;
      auto first = std::upper_bound(track.times.begin(), track.times.end(), first_s);
      auto last = std::lower_bound(track.times.begin(), track.times.end(), last_s);
      return last - first > kTimes / 2;
    };
    if (std::any_of(clip.tracks.begin(), clip.tracks.end(), is_dense)) return false;
  }
  return true;
}

// Times of the poses: evenly over the exposure, and at keys in between.
static std::vector<double> timesOf(const Scene& scene, const FrameView& frame) {
  std::vector<double> times = frame.earlier_s;
  times.insert(times.end(), {frame.raster_s, frame.previous_s});
  for (int i = 0; i < kTimes; ++i) times.push_back(glm::mix(frame.open_s, frame.close_s, i / (kTimes - 1.0)));
  auto [first, last] = std::minmax_element(times.begin(), times.end());
  const double from_s = *first, to_s = *last;
  for (const Animation& clip : scene.animations) {
    const double offset_s = from_s - clipTime(from_s, clip.duration);
    for (const Track& track : clip.tracks)
      for (double key_s : track.times)
        if (track.isOfTransform() && key_s + offset_s > from_s && key_s + offset_s < to_s)
          times.push_back(key_s + offset_s);
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

// ---- areas of the picture

// Pixels around the rectangle [low, high) from the middle of the picture, clipped to the picture.
static PixelArea areaOf(const dvec2& low, const dvec2& high, const FrameView& frame) {
  const dvec2 middle = dvec2(frame.width, frame.height) * 0.5, size = middle * 2.0;
  const dvec2 from = glm::clamp(glm::floor(middle + low), dvec2(0), size);
  const dvec2 to = glm::clamp(glm::ceil(middle + high), dvec2(0), size);
  return {int(from.x), int(from.y), int(to.x), int(to.y)};
}

void include(PixelArea& area, const PixelArea& other) {
  if (other.empty()) return;
  if (area.empty()) area = other;
  area = {std::min(area.x0, other.x0), std::min(area.y0, other.y0), std::max(area.x1, other.x1),
          std::max(area.y1, other.y1)};
}

static const Corners& cornersAt(const Track8& box, const std::vector<double>& times, double time_s) {
  return box[size_t(std::lower_bound(times.begin(), times.end(), time_s) - times.begin())];
}

// Upper bound of the error at shutter open and close, px, if the motion since the previous frame is extrapolated.
// Points of a box are between its corners, but their shares vary with the depth: the error of random points is below
// the error of the corners times the ratio of depths.
static double offTheExtrapolated(const Track8& box, const std::vector<double>& times, const FrameView& frame) {
  double off_px = 0, least_z = INFINITY, most_z = 0;
  if (!(frame.previous_s < frame.raster_s)) return off_px;
  const Corners &now = cornersAt(box, times, frame.raster_s), &previous = cornersAt(box, times, frame.previous_s);
  for (double end_s : {frame.open_s, frame.close_s})
    for (size_t c = 0; c < now.size(); ++c) {
      const double frames = (end_s - frame.raster_s) / (frame.raster_s - frame.previous_s);
      const dvec2 extrapolated = pixelOf(now[c]) + frames * (pixelOf(now[c]) - pixelOf(previous[c]));
      const Homogeneous& there = cornersAt(box, times, end_s)[c];
      off_px = std::max(off_px, glm::length(extrapolated - pixelOf(there)));
      least_z = std::min({least_z, now[c].z, previous[c].z, there.z});
      most_z = std::max({most_z, now[c].z, previous[c].z, there.z});
    }
  return off_px * most_z / least_z;
}

// Largest distance of a corner from uniform straight motion between the ends of the exposure, px. A line through the
// raster time has the same error at most, and a parabola or an arc through poses in between at most about twice the
// error.
static double offTheLine(const Track8& box, const std::vector<double>& times, const FrameView& frame) {
  double off_px = 0;
  if (!(frame.open_s < frame.close_s)) return off_px;
  const Corners &open = cornersAt(box, times, frame.open_s), &close = cornersAt(box, times, frame.close_s);
  for (size_t k = 0; k < times.size(); ++k) {
    if (times[k] < frame.open_s || times[k] > frame.close_s) continue;
    const double part = (times[k] - frame.open_s) / (frame.close_s - frame.open_s);
    for (size_t c = 0; c < open.size(); ++c)
      off_px = std::max(off_px, glm::length(pixelOf(box[k][c]) - glm::mix(pixelOf(open[c]), pixelOf(close[c]), part)));
  }
  return off_px;
}

// Adds the pixels around a box during the exposure.
static void addTo(PixelArea& moving_rect, const Track8& box, const std::vector<double>& times, const FrameView& frame) {
  Extent extent;
  double step_px = 0;
  const Corners* before = nullptr;
  for (size_t k = 0; k < times.size(); ++k) {
    if (times[k] < frame.open_s || times[k] > frame.close_s) {
      if (times[k] == frame.raster_s) extent.add(box[k]);
      continue;
    }
    extent.add(box[k]);
    for (size_t c = 0; c < 8 && before; ++c)
      step_px = std::max(step_px, glm::length(pixelOf(box[k][c]) - pixelOf((*before)[c])));
    before = &box[k];
  }
  const double bent_px = offTheExtrapolated(box, times, frame) + 2 * offTheLine(box, times, frame);
  const double margin = step_px + 2 + bent_px;
  include(moving_rect, areaOf(extent.low - margin, extent.high + margin, frame));
}

// ---- paths

// True if another object may be in front of the instance.
static bool mayBeCovered(const std::vector<std::optional<Extent>>& extents, size_t index) {
  const Extent& own = *extents[index];
  for (size_t i = 0; i < extents.size(); ++i) {
    if (i == index) continue;
    if (!extents[i]) return true;
    const Extent& other = *extents[i];
    const bool beside =
        glm::any(glm::lessThan(other.high + 2.0, own.low)) || glm::any(glm::greaterThan(other.low - 2.0, own.high));
    if (!beside && !(other.nearest > own.farthest)) return true;
  }
  return false;
}

// Box at each pose; nothing if a corner is not clearly in front of the camera.
static std::optional<Track8> posedBox(const Hull& hull, size_t box, const std::vector<Pose>& poses, size_t index,
                                      const View& view) {
  Track8 track;
  for (const Pose& pose : poses) {
    const std::array<dvec3, 8> corners = hull.corners(pose, index, box);
    Corners& posed = track.emplace_back();
    for (size_t c = 0; c < 8; ++c) {
      std::optional<Homogeneous> h = view.of(corners[c]);
      if (!h) return std::nullopt;
      posed[c] = *h;
    }
  }
  return track;
}

// Bounds of an instance over all poses; nothing if it is not clearly in front of the camera.
static std::optional<Extent> extentOf(const Hull& hull, const std::vector<Pose>& poses, size_t index,
                                      const View& view) {
  Extent extent;
  for (size_t box = 0; box < hull.boxes(); ++box) {
    std::optional<Track8> posed = posedBox(hull, box, poses, index, view);
    if (!posed) return std::nullopt;
    for (const Corners& corners : *posed) extent.add(corners);
  }
  return extent;
}

// Pixels around all moving objects at one pose, in the view of the raster time. The whole picture if an object is not
// clearly in front of the camera.
static PixelArea areaAt(const Pose& pose, const std::vector<std::pair<size_t, Hull>>& moving, const View& view,
                        const FrameView& frame) {
  PixelArea area;
  for (const auto& [index, hull] : moving) {
    std::optional<Extent> extent = extentOf(hull, {pose}, index, view);
    if (!extent) return {0, 0, frame.width, frame.height};
    include(area, areaOf(extent->low - 2.0, extent->high + 2.0, frame));
  }
  return area;
}

// Adds a moving instance to the moving rectangle, and sets `curved` and `turns`. False if the instance is not clearly
// in front of the camera.
static bool follow(const Hull& hull, const std::vector<Pose>& poses, const std::vector<double>& times, size_t index,
                   const View& view, const FrameView& frame, ScreenMotion& motion) {
  ScreenPath& path = motion.paths[index];
  for (size_t box = 0; box < hull.boxes(); ++box) {
    std::optional<Track8> posed = posedBox(hull, box, poses, index, view);
    if (!posed) return false;
    addTo(motion.moving_rect, *posed, times, frame);
    Extent extent;
    for (const Corners& corners : *posed) extent.add(corners);
    path.curved = path.curved || !(bentBy(*posed, times, extent) <= kTolerancePx);
    path.turns = path.turns || path.curved || !(turnedBy(*posed, extent) <= kTolerancePx);
  }
  return true;
}

// ---- all

static bool isSmall(const Scene& scene, const std::vector<Instance>& instances) {
  size_t vertices = 0;
  for (const Instance& instance : instances) vertices += vertexCount(scene, instance);
  return vertices <= kMostFollowed;
}

ScreenMotion screenMotionOf(const Scene& scene, const std::function<Pose(double)>& pose_at, const FrameView& frame) {
  const std::vector<Instance> instances = instancesOf(scene);
  ScreenMotion unknown;
  unknown.moving_rect = {0, 0, frame.width, frame.height};
  unknown.paths.resize(instances.size());
  const std::vector<double> times = timesOf(scene, frame);
  if (!isFollowed(scene, times.front(), times.back(), (frame.close_s - frame.open_s) / (kTimes - 1))) return unknown;
  std::vector<Pose> poses;
  for (double time_s : times) poses.push_back(pose_at(time_s));
  const std::vector<Pose> capture = {pose_at(frame.raster_s)};
  const bool camera_moves = std::any_of(poses.begin(), poses.end(), [&](const Pose& pose) {
    return pose.world_from_camera != capture[0].world_from_camera || pose.camera != capture[0].camera;
  });
  const bool is_small = isSmall(scene, instances);
  std::vector<bool> moves(instances.size());  // on the screen
  for (size_t i = 0; i < instances.size(); ++i)
    moves[i] = (camera_moves && is_small) || std::any_of(poses.begin(), poses.end(), [&](const Pose& pose) {
                 return pose.world_from_instance[i] != capture[0].world_from_instance[i] ||
                        pose.bends[i] != capture[0].bends[i];
               });
  std::vector<std::optional<Hull>> hulls(instances.size());
  for (size_t i = 0; i < instances.size(); ++i)
    if (moves[i] || is_small) hulls[i].emplace(scene, instances[i]);
  if (camera_moves) return unknown;
  const View view(capture[0], frame.height);

  ScreenMotion motion;
  motion.paths.assign(instances.size(), {false, false, false});
  std::vector<std::optional<Extent>> extents(instances.size());
  for (size_t i = 0; i < instances.size(); ++i) {
    if (!hulls[i]) continue;
    extents[i] = extentOf(*hulls[i], moves[i] ? poses : capture, i, view);
    if (!moves[i]) continue;
    motion.paths[i].curved = motion.paths[i].turns = bends(scene, instances[i]);
    if (!follow(*hulls[i], poses, times, i, view, frame, motion)) return unknown;
  }
  for (size_t i = 0; i < instances.size(); ++i) {
    if (!moves[i]) continue;
    ScreenPath& path = motion.paths[i];
    path.may_be_occluded = path.turns || mayBeCovered(extents, i);
  }
  // Paths through poses of earlier frames may continue anywhere.
  if (!frame.earlier_s.empty()) motion.moving_rect = unknown.moving_rect;
  auto moving = std::make_shared<std::vector<std::pair<size_t, Hull>>>();
  for (size_t i = 0; i < instances.size(); ++i)
    if (moves[i]) moving->emplace_back(i, std::move(*hulls[i]));
  motion.area_at = [moving, view, frame](const Pose& pose) { return areaAt(pose, *moving, view, frame); };
  return motion;
}

}  // namespace strobe::scene
