// SPDX-License-Identifier: MIT
#include "scene/defaults.h"

#include <algorithm>
#include <cmath>

#include "math/constants.h"
#include "scene/bend.h"
#include "scene/motion.h"

namespace strobe::scene {

static Bounds boundsOf(const Mesh& mesh) {
  Bounds bounds;
  for (const Geometry& geometry : mesh.geometries)
    for (uint32_t index : geometry.indices) bounds.add(mesh.origin + dvec3(geometry.vertices[index].position));
  return bounds;
}

// Bounds of all instances of `pose`. `worlds`: world-from-node of every node in this pose.
static Bounds boundsOf(const Scene& scene, const std::vector<Bounds>& meshes, const std::vector<dmat4>& worlds,
                       const Pose& pose) {
  Bounds all;
  const std::vector<Instance> instances = instancesOf(scene);
  for (size_t i = 0; i < instances.size(); ++i) {
    const Bounds& own = meshes[size_t(instances[i].mesh)];
    if (own.empty()) continue;
    const bool follows = scene.nodes[size_t(instances[i].node)].skin >= 0;
    if (follows || bends(scene, instances[i])) all.add(posedBounds(scene, instances, i, pose));
    else all.add(own.transformed(worlds[size_t(instances[i].node)] * instances[i].node_from_instance));
  }
  return all;
}

static std::vector<Bounds> meshBounds(const Scene& scene) {
  std::vector<Bounds> meshes;
  for (const Mesh& mesh : scene.meshes) meshes.push_back(boundsOf(mesh));
  return meshes;
}

Bounds boundsOf(const Scene& scene) { return boundsOf(scene, meshBounds(scene), restWorlds(scene), restPose(scene)); }

// Bounds over all poses of the scene's animations, sampled over the longest clip.
static Bounds boundsInTime(const Scene& scene) {
  double duration_s = 0;
  for (const Animation& clip : scene.animations) duration_s = std::max(duration_s, clip.duration);
  std::vector<Bounds> meshes = meshBounds(scene);
  Poser poser(scene, -1);
  Bounds all;
  int samples = duration_s > 0 ? 16 : 1;
  for (int i = 0; i < samples; ++i) {
    double time_s = samples > 1 ? duration_s * i / (samples - 1) : 0;
    all.add(boundsOf(scene, meshes, poser.nodesAt(time_s, time_s), poser.at(time_s)));
  }
  return all;
}

static bool hasCamera(const Scene& scene) {
  return std::any_of(scene.nodes.begin(), scene.nodes.end(), [](const Node& node) { return node.camera >= 0; });
}

// Distance of the camera such that a 16:9 picture contains all corners of the bounds, with a margin of 8 %.
static double framingDistance(const Bounds& bounds, const dmat3& world_from_camera, double vertical_fov) {
  double up = std::tan(vertical_fov / 2), right = up * 16 / 9, distance = 0;
  for (int corner = 0; corner < 8; ++corner) {
    dvec3 side(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    dvec3 seen = glm::transpose(world_from_camera) * (side * (bounds.high - bounds.low) * 0.5);
    distance = std::max({distance, seen.z + std::abs(seen.y) / up, seen.z + std::abs(seen.x) / right});
  }
  return distance * 1.08;
}

static void addCamera(Scene& scene) {
  Bounds bounds = boundsInTime(scene);
  if (bounds.empty()) bounds = {dvec3(-1), dvec3(1)};
  Camera camera;
  camera.name = "default";
  camera.vertical_fov = glm::radians(40.0);

  Node node;
  node.name = "default camera";
  node.transform.rotation =
      glm::angleAxis(glm::radians(20.0), dvec3(0, 1, 0)) * glm::angleAxis(glm::radians(-15.0), dvec3(1, 0, 0));
  dmat3 world_from_camera = glm::mat3_cast(node.transform.rotation);
  double distance = framingDistance(bounds, world_from_camera, camera.vertical_fov);
  if (distance <= 0) distance = 1;
  node.transform.translation = bounds.middle() + world_from_camera[2] * distance;
  node.camera = int(scene.cameras.size());
  camera.near = distance * 1e-3;
  scene.cameras.push_back(camera);
  scene.nodes.push_back(node);
  scene.assumptions.push_back(
      "no camera in the scene: added a camera that frames the scene, vertical angle 40 degrees");
}

static bool needsLight(const Scene& scene) {
  for (const Node& node : scene.nodes) {
    if (node.mesh < 0) continue;
    for (const Geometry& geometry : scene.meshes[node.mesh].geometries)
      if (!scene.materials[geometry.material].unlit) return true;
  }
  return false;
}

static void addLight(Scene& scene, int camera) {
  Light light;
  light.name = "default light";
  light.type = Light::Type::Directional;
  light.color = vec3(1.6f, 1.52f, 1.4f);
  light.shadow = false;
  Node node;
  node.name = "default light";
  node.parent = camera;
  node.transform.rotation =
      glm::angleAxis(glm::radians(-20.0), dvec3(0, 1, 0)) * glm::angleAxis(glm::radians(-20.0), dvec3(1, 0, 0));
  node.light = int(scene.lights.size());
  scene.lights.push_back(light);
  scene.nodes.push_back(node);
  scene.assumptions.push_back(
      "no light in the scene: added a directional light of 1.6 1.52 1.4 lux at the camera, without shadows");
}

void supplyDefaults(Scene& scene, const std::string& camera) {
  if (!hasCamera(scene)) addCamera(scene);
  if (!lightsOf(scene).empty() || !needsLight(scene)) return;
  addLight(scene, cameraNode(scene, camera));
  Environment& environment = scene.environment;
  if (environment.sky != vec3(0) || environment.ground != vec3(0)) return;
  environment.sky = vec3(0.42f, 0.45f, 0.50f);
  environment.ground = vec3(0.22f, 0.20f, 0.18f);
  scene.assumptions.push_back("no environment in the scene: added a sky of .42 .45 .50 over a ground of .22 .20 .18");
}

void moderateLights(Scene& scene) {
  std::vector<int> nodes = lightsOf(scene);
  Bounds bounds = boundsOf(scene);
  if (nodes.empty() || bounds.empty()) return;
  std::vector<dmat4> worlds = restWorlds(scene);
  double least = std::max(bounds.radius() * 0.1, 1e-9), lux = 0;
  for (int node : nodes) {
    const Light& light = scene.lights[scene.nodes[node].light];
    vec3 emitted = light.emitted();
    double strength = 0.2126 * emitted.x + 0.7152 * emitted.y + 0.0722 * emitted.z;
    double distance = std::max(least, glm::distance(dvec3(worlds[node][3]), bounds.middle()));
    lux += light.type == Light::Type::Directional ? strength : strength / (distance * distance);
  }
  if (!(lux > 0) || !std::isfinite(lux) || (lux >= 0.3 && lux <= 10)) return;
  double factor = kPi / lux;
  for (Light& light : scene.lights) light.moderation *= float(factor);
  scene.assumptions.push_back(
      fmt::format("the lights give about {:.4g} lux: all intensities are multiplied by {:.4g}", lux, factor));
}

}  // namespace strobe::scene
