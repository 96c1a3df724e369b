// SPDX-License-Identifier: MIT
// Displacements of every sample scene by rasterisation and by ray tracing, against differences of positions projected
// in double precision.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "common/home.h"
#include "common/source.h"
#include "lab/frame.h"
#include "oracle/render.h"
#include "scene/bend.h"
#include "scene/defaults.h"

namespace strobe::oracle {
namespace render_displacements_test {

namespace fs = std::filesystem;

constexpr int kWidth = 64, kHeight = 40;

// Pixel coordinates of a world position; nothing for positions behind the camera or near its plane.
std::optional<dvec2> pixelOf(const scene::Pose& pose, const dvec3& position_ws) {
  dvec3 seen(glm::inverse(pose.world_from_camera) * dvec4(position_ws, 1));
  const scene::Camera& camera = pose.camera;
  double up = camera.orthographic ? camera.half_height : std::tan(camera.vertical_fov / 2) * -seen.z;
  if (!camera.orthographic && -seen.z < 2 * camera.near) return std::nullopt;
  double scale = kHeight / (2 * up);
  return dvec2(kWidth / 2. + seen.x * scale, kHeight / 2. - seen.y * scale);
}

class RenderDisplacements : public RenderTest {
 protected:
  struct Seen {
    lab::Picture picture;
    const scene::Scene* scene = nullptr;
    scene::Pose capture, open, close;
    std::array<std::vector<std::vector<scene::BentVertex>>, 3> bent;  // at these poses; deformed instances only
    std::shared_ptr<lab::HeldScene> held;
  };

  static std::vector<Path> files() {
    std::vector<Path> found;
    std::optional<Path> data = home().data();
    if (!data || !fs::is_directory(*data / "scenes")) return found;
    for (const auto& entry : fs::recursive_directory_iterator(*data / "scenes")) {
      std::string extension = entry.path().extension().string();
      if (extension == ".glb" || extension == ".gltf") found.push_back(entry.path());
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  static lab::Shot shotOfFile(const Path& file) {
    lab::Shot shot;
    shot.scene = file;
    shot.width = kWidth;
    shot.height = kHeight;
    shot.fps = 24;
    shot.frame = 0;
    shot.anchor = "centre";
    shot.pipeline = sourceFolder() / "tests/oracle/pipelines/two_ways.lua";
    return shot;
  }

  static Seen see(lab::Shot shot) {
    Seen seen;
    seen.held = bench().scene(shot);
    seen.scene = &seen.held->scene;
    graph::Frame setup = lab::frameOf(shot, *seen.scene);
    seen.capture = setup.pose_at(setup.view.raster_s);
    seen.open = setup.pose_at(setup.view.open_s);
    seen.close = setup.pose_at(setup.view.close_s);
    const std::vector<scene::Instance> instances = scene::instancesOf(*seen.scene);
    const scene::Pose* poses[] = {&seen.capture, &seen.open, &seen.close};
    for (size_t p = 0; p < 3; ++p)
      for (size_t i = 0; i < instances.size(); ++i) {
        seen.bent[p].emplace_back();
        if (scene::bends(*seen.scene, instances[i]))
          seen.bent[p][i] = scene::bentVertices(*seen.scene, instances[i], poses[p]->bends[i]);
      }
    seen.picture = render(shot);
    return seen;
  }

  // World-space corners of a hit triangle at a pose (0: raster time, 1: shutter opening, 2: shutter closing).
  static std::array<dvec3, 3> cornersAt(const Seen& seen, size_t pose, size_t instance, uint32_t geometry,
                                        uint32_t triangle) {
    const scene::Mesh& mesh = seen.scene->meshes[size_t(scene::instancesOf(*seen.scene)[instance].mesh)];
    const std::vector<scene::BentVertex>& bent = seen.bent[pose][instance];
    const scene::Pose& posed = pose == 0 ? seen.capture : pose == 1 ? seen.open : seen.close;
    size_t first = 0;
    for (size_t g = 0; g < geometry; ++g) first += mesh.geometries[g].vertices.size();
    std::array<dvec3, 3> corners;
    for (size_t c = 0; c < 3; ++c) {
      const size_t vertex = mesh.geometries[geometry].indices[3 * size_t(triangle) + c];
      dvec3 position =
          bent.empty() ? dvec3(mesh.geometries[geometry].vertices[vertex].position) : bent[first + vertex].position;
      corners[c] = dvec3(posed.world_from_instance[instance] * dvec4(position, 1));
    }
    return corners;
  }

  // Node of the instance with the most triangles.
  static std::string largestNode(const scene::Scene& scene) {
    size_t most = 0;
    int largest = 0;
    for (const scene::Instance& instance : scene::instancesOf(scene)) {
      size_t triangles = 0;
      for (const auto& geometry : scene.meshes[size_t(instance.mesh)].geometries) triangles += geometry.indices.size();
      if (triangles > most) most = triangles, largest = instance.node;
    }
    return scene.nodes[size_t(largest)].name;
  }

  // A shot within the longest clip; the largest object and the file's camera get additional motion.
  static lab::Shot movingShot(const Path& file) {
    lab::Shot shot = shotOfFile(file);
    auto held = bench().scene(shot);
    const scene::Scene& scene = held->scene;
    double duration_s = 0, radius = scene::boundsOf(scene).radius();
    for (const scene::Animation& clip : scene.animations) duration_s = std::max(duration_s, clip.duration);
    shot.frame = int(0.37 * duration_s * shot.fps);
    std::string object = largestNode(scene);
    shot.moves = {fmt::format("{}=0,{},{}", object, radius * 0.03, radius * 0.01)};
    shot.spins = {fmt::format("{}=0,1,0,5", object)};
    const scene::Node& camera = scene.nodes[size_t(scene::cameraNode(scene, ""))];
    bool is_of_file = camera.name != "default camera";
    if (is_of_file) shot.moves.push_back(fmt::format("{}={},0,{}", camera.name, radius * 0.02, radius * -0.01));
    return shot;
  }

  // Displacement of the triangle's point at a pixel's centre, from its projections at both ends of the exposure.
  // Nothing if the ray meets the plane outside the triangle, or at an angle too flat for single precision.
  static std::optional<dvec2> differenceAt(const Seen& seen, int x, int y, const image::UintImage& hit) {
    const size_t at = hit.at(x, y, 0) - 1;
    const auto world = cornersAt(seen, 0, at, hit.at(x, y, 1), hit.at(x, y, 2));
    const scene::Camera& camera = seen.capture.camera;
    const dmat4& frame = seen.capture.world_from_camera;
    double up = camera.orthographic ? camera.half_height : std::tan(camera.vertical_fov / 2);
    dvec2 side((2 * (x + .5) / kWidth - 1) * up * kWidth / kHeight, (1 - 2 * (y + .5) / kHeight) * up);
    dvec3 offset = dvec3(frame[0]) * side.x + dvec3(frame[1]) * side.y;
    dvec3 origin = dvec3(frame[3]) + (camera.orthographic ? offset : dvec3(0));
    dvec3 direction = -dvec3(frame[2]) + (camera.orthographic ? dvec3(0) : offset);
    dvec3 edge1 = world[1] - world[0], edge2 = world[2] - world[0], p = glm::cross(direction, edge2);
    double determinant = glm::dot(edge1, p);
    dvec3 normal = glm::normalize(glm::cross(edge1, edge2));
    if (std::abs(glm::dot(normal, glm::normalize(direction))) < 0.05) return std::nullopt;
    dvec3 from = origin - world[0], q = glm::cross(from, edge1);
    double u = glm::dot(from, p) / determinant, v = glm::dot(direction, q) / determinant;
    if (!(u >= 0 && v >= 0 && u + v <= 1)) return std::nullopt;
    auto pointAt = [&](size_t pose) {
      const auto corner = cornersAt(seen, pose, at, hit.at(x, y, 1), hit.at(x, y, 2));
      return corner[0] + u * (corner[1] - corner[0]) + v * (corner[2] - corner[0]);
    };
    auto end = pixelOf(seen.close, pointAt(2)), start = pixelOf(seen.open, pointAt(1));
    if (!start || !end) return std::nullopt;
    return *end - *start;
  }

  struct Found {
    int pixels = 0, alike = 0;
    double against_difference = 0, against_rays = 0, longest = 0;
  };

  static Found measure(const Seen& seen) {
    const image::Image &raster = imageOf(seen.picture, "velocity"), &rays = imageOf(seen.picture, "ray_velocity");
    const image::UintImage& hit = seen.picture.frame.outputs.at("hit").uints;
    const image::UintImage& ray_hit = seen.picture.frame.outputs.at("ray_hit").uints;
    Found found;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        if (hit.at(x, y, 0) == 0) continue;
        dvec2 here(raster.at(x, y, 0), raster.at(x, y, 1)), there(rays.at(x, y, 0), rays.at(x, y, 1));
        bool same = true;
        for (int c = 0; c < 3; ++c) same = same && hit.at(x, y, c) == ray_hit.at(x, y, c);
        if (same) found.against_rays = std::max(found.against_rays, glm::distance(here, there)), ++found.alike;
        auto difference = differenceAt(seen, x, y, hit);
        if (!difference) continue;
        ++found.pixels;
        found.longest = std::max(found.longest, glm::length(here));
        found.against_difference = std::max(found.against_difference, glm::distance(here, *difference));
      }
    return found;
  }
};

TEST_F(RenderDisplacements, MatchDifferencesOfProjectedPositions) {
  if (files().empty()) GTEST_SKIP() << "no shared scenes (set STROBE_DATA)";
  int moving = 0, bending = 0, all = 0;
  for (const Path& file : files()) {
    Seen seen = see(movingShot(file));
    Found found = measure(seen);
    EXPECT_LE(found.against_difference, 1e-3) << file << ", up to " << found.longest << " px";
    EXPECT_LE(found.against_rays, 1e-3) << file;
    EXPECT_GT(found.pixels, 10) << file;
    moving += found.longest > 0.05;
    for (const auto& bent : seen.bent[0]) bending += !bent.empty();
    ++all;
    RecordProperty(file.filename().string(),
                   fmt::format("{:.2e} {:.2e} px of {:.2f}, {} and {} pixels", found.against_difference,
                               found.against_rays, found.longest, found.pixels, found.alike));
  }
  EXPECT_GE(moving, all - 1);
  EXPECT_GE(bending, 20);
}

// Scenes deformed by joints and morph targets, seen from near at several times of their clips.
TEST_F(RenderDisplacements, MatchOnDeformedSurfacesFromNear) {
  std::optional<Path> data = home().data();
  if (!data || files().empty()) GTEST_SKIP() << "no shared scenes (set STROBE_DATA)";
  for (const char* name :
       {"khronos_samples/CesiumMan.glb", "khronos_samples/RiggedSimple.glb", "khronos_samples/AnimatedMorphCube.glb",
        "khronos_samples/AnimatedMorphSphere.glb", "vintage_desk_fan/vintage_desk_fan.glb"})
    for (int frame : {5, 14, 23}) {
      lab::Shot shot = shotOfFile(*data / "scenes" / name);
      if (!fs::exists(shot.scene)) continue;
      shot.frame = frame;
      const scene::Scene& scene = bench().scene(shot)->scene;
      const scene::Pose pose = lab::frameOf(shot, scene).pose_at(shot.rasterTime());
      const std::vector<scene::Instance> instances = scene::instancesOf(scene);
      Bounds bounds;
      for (size_t i = 0; i < instances.size(); ++i) bounds.add(scene::posedBounds(scene, instances, i, pose));
      const dvec3 at = bounds.middle(), from = at + bounds.radius() * dvec3(0.7, 0.5, 1.4);
      shot.view = {from.x, from.y, from.z, at.x, at.y, at.z};
      Found found = measure(see(shot));
      EXPECT_LE(found.against_difference, 1e-3) << name << ", up to " << found.longest << " px";
      EXPECT_LE(found.against_rays, 1e-3) << name;
      EXPECT_GT(found.pixels, 150) << name;
      RecordProperty(fmt::format("{}.{}", name, frame),
                     fmt::format("{:.2e} {:.2e} px of {:.2f}, {} and {} pixels", found.against_difference,
                                 found.against_rays, found.longest, found.pixels, found.alike));
    }
}

// Jumps of stepped channels leave no displacement on either side of the raster time.
TEST_F(RenderDisplacements, SteppedChannelsHaveNoDisplacement) {
  std::optional<Path> data = home().data();
  Path file = data ? *data / "scenes/khronos_samples/InterpolationTest.glb" : "";
  if (!data || !fs::exists(file)) GTEST_SKIP() << "no shared scenes (set STROBE_DATA)";
  lab::Shot shot = shotOfFile(file);
  auto held = bench().scene(shot);
  int clips = 0;
  for (const scene::Animation& clip : held->scene.animations) {
    if (clip.tracks.at(0).interpolation != scene::Track::Interpolation::Step) continue;
    shot.animation = clip.name;
    shot.frame = int(clip.tracks[0].times.at(1) * shot.fps);  // a key lies between this frame and the next
    shot.exposure = 4;
    lab::Picture picture = render(shot);
    EXPECT_EQ(rms(imageOf(picture, "velocity")), 0) << clip.name;
    ++clips;
  }
  EXPECT_EQ(clips, 3);
}

}  // namespace render_displacements_test
}  // namespace strobe::oracle
