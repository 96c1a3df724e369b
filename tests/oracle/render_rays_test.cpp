// SPDX-License-Identifier: MIT
// Rays that are hard for single precision, through every ray tracing backend and through Embree: to vertices and edges,
// along surfaces and axes, from far away. If two results differ, the ray must pass the triangle within rounding of its
// border or along its plane, or start on it, as computed in double precision.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>

#include "common/home.h"
#include "common/source.h"
#include "lab/drawing.h"
#include "lab/frame.h"
#include "oracle/render.h"
#include "scene/bend.h"

#if __has_include(<embree3/rtcore.h>)
#include <embree3/rtcore.h>
#define HAS_EMBREE 1
#endif

namespace strobe::oracle {
namespace render_rays_test {

const std::string kRays = sourceFolder().string() + "/scripts/inspect/test_rays.lua";
const char* const kKinds[] = {"through", "vertex", "edge", "axis", "grazing", "afar", "surface", "plane"};

// Rays go through each scene as the pixels of a picture twice as wide as high: 512x256, or at least STROBE_RAYS pixels.
// The rows cycle through the kinds of rays.
int height() {
  const char* asked = std::getenv("STROBE_RAYS");
  const double rays = asked ? std::atof(asked) : 131072;
  return 8 * std::max(1, int(std::ceil(std::sqrt(rays / 2) / 8)));
}
int width() { return 2 * height(); }

struct Found {
  uint32_t instance = 0, geometry = 0, primitive = 0;  // instance + 1; 0: a miss
  double t = std::numeric_limits<double>::infinity();
  bool operator==(const Found& other) const {
    return instance == other.instance && (!instance || (geometry == other.geometry && primitive == other.primitive));
  }
};

// Rays and hits of one backend.
class Rays {
 public:
  explicit Rays(const lab::Picture& picture) : outputs_(picture.frame.outputs) {}

  size_t count() const { return outputs_.at("hit").uints.values.size() / 4; }
  Found hit(size_t i) const {
    const uint32_t* v = &outputs_.at("hit").uints.values[4 * i];
    return v[0] ? Found{v[0], v[1], v[2], std::bit_cast<float>(v[3])} : Found();
  }
  bool blocked(size_t i) const { return outputs_.at("blocked").uints.values[i] != 0; }
  vec3 origin(size_t i) const { return vec3Of("origin", i); }
  vec3 direction(size_t i) const { return vec3Of("direction", i); }

 private:
  vec3 vec3Of(const char* name, size_t i) const {
    const float* v = &outputs_.at(name).floats.values[4 * i];
    return {v[0], v[1], v[2]};
  }
  const std::map<std::string, graph::ReadImage>& outputs_;
};

using Triangle = std::array<dvec3, 3>;

// Triangles of a shot's scene at the raster time, relative to the camera.
class Triangles {
 public:
  explicit Triangles(lab::Shot shot, const Home& home) : loaded_(lab::loadScene(home, shot)) {
    scene::Pose pose = lab::frameOf(shot, loaded_->scene).pose_at(shot.rasterTime());
    origin_ = dvec3(pose.world_from_camera[3]);
    instances_ = scene::instancesOf(loaded_->scene);
    transforms_ = pose.world_from_instance;
    for (size_t i = 0; i < instances_.size(); ++i) {
      bent_.emplace_back();
      if (scene::bends(loaded_->scene, instances_[i]))
        bent_[i] = scene::bentVertices(loaded_->scene, instances_[i], pose.bends[i]);
    }
  }

  Triangle at(const Found& found) const {
    size_t instance = found.instance - 1;
    const scene::Geometry& geometry = geometries(instance).at(found.geometry);
    Triangle triangle;
    size_t first = 0;
    for (size_t g = 0; g < found.geometry; ++g) first += geometries(instance)[g].vertices.size();
    for (size_t c = 0; c < 3; ++c) {
      const size_t vertex = geometry.indices[3 * found.primitive + c];
      const std::vector<scene::BentVertex>& bent = bent_[instance];
      dvec3 corner = bent.empty() ? dvec3(geometry.vertices[vertex].position) : bent[first + vertex].position;
      triangle[c] = dvec3(transforms_[instance] * dvec4(corner, 1)) - origin_;
    }
    return triangle;
  }

  std::vector<Found> all() const {
    std::vector<Found> names;
    for (size_t i = 0; i < instances_.size(); ++i)
      for (size_t g = 0; g < geometries(i).size(); ++g)
        for (size_t p = 0; p < geometries(i)[g].indices.size() / 3; ++p)
          names.push_back({uint32_t(i + 1), uint32_t(g), uint32_t(p)});
    return names;
  }

 private:
  const std::vector<scene::Geometry>& geometries(size_t instance) const {
    return loaded_->scene.meshes[size_t(instances_[instance].mesh)].geometries;
  }
  std::shared_ptr<lab::HeldScene> loaded_;
  dvec3 origin_;
  std::vector<scene::Instance> instances_;
  std::vector<dmat4> transforms_;
  std::vector<std::vector<scene::BentVertex>> bent_;  // empty for rigid instances
};

double distanceToSegment(const dvec3& p, const dvec3& a, const dvec3& b) {
  double length2 = glm::dot(b - a, b - a);
  double s = length2 > 0 ? std::clamp(glm::dot(p - a, b - a) / length2, 0.0, 1.0) : 0;
  return glm::length(p - (a + s * (b - a)));
}

// Sine of the angle between a ray and a triangle. An offset of the ray moves its hit by the offset divided by the sine.
double slantOf(const Triangle& triangle, const dvec3& direction) {
  dvec3 normal = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  double lengths = glm::length(normal) * glm::length(direction);
  return lengths > 0 ? std::abs(glm::dot(normal, direction)) / lengths : 0;
}

// True if rounding may decide whether this ray hits this triangle.
bool isBorderline(const Triangle& triangle, const dvec3& origin, const dvec3& direction) {
  double size = glm::length(origin);
  for (const dvec3& corner : triangle) size = std::max(size, glm::length(corner));
  const double rounding = 1e-5 * size;
  dvec3 normal = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  const double slant = slantOf(triangle, direction);
  if (slant <= 1e-4) return true;
  double t = glm::dot(normal, triangle[0] - origin) / glm::dot(normal, direction);
  if (std::abs(t) * glm::length(direction) <= rounding / slant) return true;
  dvec3 p = origin + t * direction;
  for (size_t c = 0; c < 3; ++c)
    if (distanceToSegment(p, triangle[c], triangle[(c + 1) % 3]) <= rounding / slant) return true;
  return false;
}

class RenderRays : public RenderTest {
 protected:
  static lab::Shot shotThrough(const std::string& scene) {
    const bool is_own = scene == "living_room" || scene.starts_with("/");
    lab::Shot shot = shotOf(is_own ? "crowd" : scene, width(), height());
    if (is_own) shot.scene = scene;
    if (scene.starts_with("/")) shot.frame = 10, shot.faces = "both", shot.sets.clear();
    return with(shot, kRays);
  }

  // Rigid scenes and, without STROBE_RAYS, one scene deformed by joints and one deformed by morph targets.
  static std::vector<std::string> scenes(std::vector<std::string> rigid) {
    std::optional<Path> data = home().data();
    for (const char* name : {"CesiumMan", "AnimatedMorphSphere"}) {
      const Path file = data ? *data / "scenes/khronos_samples" / (name + std::string(".glb")) : Path();
      if (!std::getenv("STROBE_RAYS") && data && std::filesystem::exists(file)) rigid.push_back(file.string());
    }
    return rigid;
  }

  // Expects that all differences are within rounding, and reports the first few others. With STROBE_RAYS, prints for
  // each kind how many pairs of hits are in one place ("tied") or pass a border within rounding ("bordering").
  static void expectAlike(const Rays& rays, const Triangles& triangles, const std::function<Found(size_t)>& other,
                          const std::string& what) {
    int wrong = 0;
    std::array<int, std::size(kKinds)> tied{}, bordering{};
    for (size_t i = 0; i < rays.count(); ++i) {
      const Found x = rays.hit(i), y = other(i);
      if (x == y) continue;
      const size_t kind = i / size_t(width()) % std::size(kKinds);
      dvec3 origin(rays.origin(i)), direction(rays.direction(i));
      // The nearer of the two hits is in question: the other result misses it.
      const Found& nearer = x.t <= y.t ? x : y;
      if (areInOnePlace(triangles, x, y, origin, direction)) ++tied[kind];
      else if (isBorderline(triangles.at(nearer), origin, direction)) ++bordering[kind];
      else if (++wrong <= 3)
        ADD_FAILURE() << fmt::format("{}, {} ray {}: {} {} {} at {:.9g}, the other {} {} {} at {:.9g}", what,
                                     kKinds[kind], i, x.instance, x.geometry, x.primitive, x.t, y.instance, y.geometry,
                                     y.primitive, y.t);
    }
    EXPECT_EQ(wrong, 0) << what;
    if (!std::getenv("STROBE_RAYS")) return;
    auto sum = [](const auto& counts) { return std::accumulate(counts.begin(), counts.end(), 0); };
    fmt::print("{}: {} rays, {} tied, {} bordering, {} others differ;", what, rays.count(), sum(tied), sum(bordering),
               wrong);
    for (size_t kind = 0; kind < std::size(kKinds); ++kind)
      fmt::print(" {} {} {}", kKinds[kind], tied[kind], bordering[kind]);
    fmt::print("\n");
  }

 private:
  static bool areInOnePlace(const Triangles& triangles, const Found& x, const Found& y, const dvec3& origin,
                            const dvec3& direction) {
    double size = std::max(glm::length(origin), glm::length(origin + direction * std::min(x.t, y.t)));
    double slant = 1;
    for (const Found& one : {x, y})
      if (one.instance) slant = std::min(slant, slantOf(triangles.at(one), direction));
    return std::abs(x.t - y.t) * glm::length(direction) * slant <= 1e-5 * size;
  }
};

TEST_F(RenderRays, BackendsHitTheSameTriangles) {
  for (const std::string& scene : scenes({"crowd", "cut_out", "solids", "living_room"})) {
    lab::Shot shot = shotThrough(scene);
    Triangles triangles(shot, bench().home());
    std::vector<lab::Picture> pictures;
    for (const std::string& backend : backends()) {
      shot.backend = backend;
      pictures.push_back(render(shot));
      Rays rays(pictures.back());
      size_t hits = 0;
      for (size_t i = 0; i < rays.count(); ++i) {
        hits += rays.hit(i).instance > 0;
        // A ray is blocked exactly if it has a nearest hit.
        ASSERT_EQ(rays.blocked(i), rays.hit(i).instance > 0) << scene << ", " << backend << ", ray " << i;
      }
      EXPECT_GT(hits, rays.count() / 8) << scene;
      Rays first(pictures.front());
      expectAlike(
          first, triangles, [&](size_t i) { return rays.hit(i); }, fmt::format("{}, {}", scene, backend));
      if (pictures.size() > 1) pictures.pop_back();
    }
  }
}

#ifdef HAS_EMBREE
// An independent ray tracer over the same triangles.
class Embree {
 public:
  explicit Embree(const Triangles& triangles) : names_(triangles.all()) {
    device_ = rtcNewDevice("threads=1");
    scene_ = rtcNewScene(device_);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry mesh = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    size_t count = names_.size();
    auto* corners =
        static_cast<float*>(rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, 3 * count));
    auto* indices =
        static_cast<uint32_t*>(rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, count));
    for (size_t i = 0; i < count; ++i)
      for (size_t c = 0; c < 3; ++c) {
        dvec3 corner = triangles.at(names_[i])[c];
        for (int axis = 0; axis < 3; ++axis) corners[9 * i + 3 * c + size_t(axis)] = float(corner[axis]);
        indices[3 * i + c] = uint32_t(3 * i + c);
      }
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(scene_, mesh);
    rtcReleaseGeometry(mesh);
    rtcCommitScene(scene_);
  }
  ~Embree() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;

  Found nearest(const vec3& origin, const vec3& direction) const {
    RTCRayHit ray{};
    ray.ray.org_x = origin.x, ray.ray.org_y = origin.y, ray.ray.org_z = origin.z;
    ray.ray.dir_x = direction.x, ray.ray.dir_y = direction.y, ray.ray.dir_z = direction.z;
    ray.ray.tfar = 3e38f;
    ray.ray.mask = ~0u;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_, &context, &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    Found found = names_[ray.hit.primID];
    found.t = ray.ray.tfar;
    return found;
  }

 private:
  std::vector<Found> names_;
  RTCDevice device_;
  RTCScene scene_;
};

TEST_F(RenderRays, HitsMatchEmbree) {
  for (const std::string& scene : scenes({"crowd", "solids", "living_room"})) {
    lab::Shot shot = shotThrough(scene);
    shot.backend = "bvh";
    Triangles triangles(shot, bench().home());
    Embree embree(triangles);
    lab::Picture picture = render(shot);
    Rays rays(picture);
    expectAlike(
        rays, triangles, [&](size_t i) { return embree.nearest(rays.origin(i), rays.direction(i)); },
        fmt::format("{}, Embree", scene));
  }
}
#else
TEST_F(RenderRays, HitsMatchEmbree) { GTEST_SKIP() << "Embree 3 is not installed"; }
#endif

}  // namespace render_rays_test
}  // namespace strobe::oracle
