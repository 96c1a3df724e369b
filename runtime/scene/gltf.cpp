// SPDX-License-Identifier: MIT
#include "scene/gltf.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/memory.h"
#include "math/constants.h"
#include "scene/clips.h"
#include "scene/defaults.h"
#include "scene/gltf_parts.h"
#include "scene/motion.h"

namespace strobe::scene {

namespace {

class GltfLoader {
 public:
  GltfLoader(const Path& path, const GltfOptions& options) : file_(path, options.allow_outside) {
    variant_ = options.variant;
    most_bytes_ = std::min(options.most_bytes, availableMemory());
  }

  Scene load() {
    scene_.name = file_.path().stem().string();
    requireUses(file_, scene_.warnings);
    readMaterials(file_, scene_, most_bytes_);
    int variant = readVariants();
    for (size_t i = 0; i < file_.all("meshes").size(); ++i)
      scene_.meshes.push_back(readMesh(file_, int(i), {int(scene_.materials.size()) - 1, variant}, scene_.warnings));
    warnOfUnusedAttributes(file_, scene_.warnings);
    dropIdleTangents(scene_);
    readCameras();
    readLights();
    readNodes();
    hierarchyOrder(scene_);
    readSkins(file_, scene_);
    readShownScene();
    readAnimations(file_, scene_);
    yieldClips(scene_);
    findSoleJoints(scene_);
    dropIdleWeights(scene_);
    warnOfUnusedExtensions();
    readAttribution();
    moderateLights(scene_);
    scene_.files = file_.files();
    return std::move(scene_);
  }

 private:
  void warn(const std::string& text) { scene_.warnings.push_back(text); }

  // Index of the requested variant; -1 without a request.
  int readVariants() {
    const Json& variants = file_.list(file_.extension(file_.json(), "KHR_materials_variants"), "variants", "");
    if (variant_.empty()) return -1;
    const std::vector<std::string> names = file_.uniqueNames(variants, "variant");
    auto found = std::find(names.begin(), names.end(), variant_);
    if (found != names.end()) return int(found - names.begin());
    if (names.empty()) throw Error(fmt::format("{} has no material variants", scene_.name), {}, 2);
    throw Error(fmt::format("{} has no variant '{}'{}; it has {}", scene_.name, variant_, didYouMean(variant_, names),
                            fmt::join(names, ", ")),
                {}, 2);
  }

  // --- cameras and lights -----------------------------------------------------------------------------------------

  void readCameras() {
    const Json& cameras = file_.all("cameras");
    for (size_t i = 0; i < cameras.size(); ++i) {
      std::string where = fmt::format("cameras[{}]", i), type = file_.text(cameras[i], "type", where);
      Camera camera;
      camera.name = file_.text(cameras[i], "name");
      camera.orthographic = type == "orthographic";
      file_.require(cameras[i], type, where);
      readLens(file_.object(cameras[i], type, where), where, camera);
      scene_.cameras.push_back(camera);
    }
  }

  void readLens(const Json& lens, const std::string& where, Camera& camera) {
    constexpr double kLeast = 1e-30, kMost = 1e30;
    camera.near = file_.numberIn(lens, "znear", std::nullopt, camera.orthographic ? 0 : kLeast, kMost, where);
    double far = file_.number(lens, "zfar", HUGE_VAL, where);
    if (far <= camera.near) file_.refuse(where, fmt::format("zfar {} is not beyond znear {}", far, camera.near));
    if (camera.orthographic) {
      camera.half_height = file_.numberIn(lens, "ymag", std::nullopt, kLeast, kMost, where);
      file_.numberIn(lens, "xmag", std::nullopt, kLeast, kMost, where);
      return;
    }
    camera.vertical_fov = file_.numberIn(lens, "yfov", std::nullopt, 1e-4, 3.14, where);
  }

  void readLights() {
    const Json& lights = file_.list(file_.extension(file_.json(), "KHR_lights_punctual"), "lights", "");
    for (size_t i = 0; i < lights.size(); ++i) {
      std::string where = fmt::format("KHR_lights_punctual.lights[{}]", i), type = file_.text(lights[i], "type", where);
      Light light;
      light.name = file_.text(lights[i], "name");
      if (type == "directional") light.type = Light::Type::Directional;
      else if (type == "spot") light.type = Light::Type::Spot;
      auto color = file_.numbers(lights[i], "color", {1, 1, 1}, where);
      light.color = vec3(color[0], color[1], color[2]);
      light.intensity = file_.number(lights[i], "intensity", 1, where);
      light.range = file_.numberIn(lights[i], "range", 0, 1e-30, HUGE_VAL, where);
      if (light.type == Light::Type::Spot) file_.require(lights[i], "spot", where);
      const Json& spot = file_.object(lights[i], "spot", where);
      light.inner_cone = file_.number(spot, "innerConeAngle", 0, where);
      light.outer_cone = file_.number(spot, "outerConeAngle", kPi / 4, where);
      if (light.inner_cone >= light.outer_cone) file_.refuse(where, "innerConeAngle is not below outerConeAngle");
      scene_.lights.push_back(light);
    }
  }

  // --- nodes ------------------------------------------------------------------------------------------------------

  void readNodes() {
    const Json& nodes = file_.all("nodes");
    scene_.nodes.resize(nodes.size());
    const std::vector<std::string> names = file_.uniqueNames(nodes, "node");
    for (size_t i = 0; i < nodes.size(); ++i) {
      Node& node = scene_.nodes[i];
      std::string where = fmt::format("nodes[{}]", i);
      node.name = names[i];
      readTransform(nodes[i], where, node);
      node.cuts = cutsOf(file_, nodes[i], where);
      node.mesh = file_.index(nodes[i], "mesh", "meshes", where);
      node.camera = file_.index(nodes[i], "camera", "cameras", where);
      node.light = lightIndex(nodes[i], where);
      readInstancing(nodes[i], where, node);
      readChildren(nodes[i], where, int(i));
      if (node.camera >= 0 && scene_.cameras[node.camera].name.empty()) scene_.cameras[node.camera].name = node.name;
    }
  }

  void readTransform(const Json& json, const std::string& where, Node& node) {
    auto t = file_.numbers(json, "translation", {0, 0, 0}, where), s = file_.numbers(json, "scale", {1, 1, 1}, where);
    auto r = file_.numbers(json, "rotation", {0, 0, 0, 1}, where);
    node.transform.translation = {t[0], t[1], t[2]};
    node.transform.scale = {s[0], s[1], s[2]};
    dquat rotation(r[3], r[0], r[1], r[2]);
    double length = glm::length(rotation);
    if (std::abs(length - 1) > 0.01)
      file_.refuse(where, fmt::format("its rotation is a quaternion of length {}, not 1", length));
    node.transform.rotation = rotation / length;
    if (!json.contains("matrix")) return;
    for (const char* part : {"translation", "rotation", "scale"})
      if (json.contains(part)) file_.refuse(where, fmt::format("has both a matrix and a {}", part));
    auto m = file_.numbers(json, "matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, where);
    dmat4 matrix;
    for (int c = 0; c < 4; ++c) matrix[c] = dvec4(m[4 * c], m[4 * c + 1], m[4 * c + 2], m[4 * c + 3]);
    if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1) file_.refuse(where, "its matrix is not affine");
    node.matrix = matrix;
  }

  int lightIndex(const Json& json, const std::string& where) {
    bool present = false;
    const Json& extension = file_.extension(json, "KHR_lights_punctual", &present);
    if (!present) return -1;
    size_t light = file_.size(extension, "light", std::nullopt, where);
    if (light >= scene_.lights.size())
      file_.refuse(where, fmt::format("'light' is {}, but the file has {} lights", light, scene_.lights.size()));
    return int(light);
  }

  void readInstancing(const Json& json, const std::string& where, Node& node) {
    const Json& attributes = file_.object(file_.extension(json, "EXT_mesh_gpu_instancing"), "attributes", where);
    std::optional<Values> values[3];
    const char* names[3] = {"TRANSLATION", "ROTATION", "SCALE"};
    size_t count = 0;
    for (int k = 0; k < 3; ++k) {
      int index = file_.index(attributes, names[k], "accessors", where);
      if (index < 0) continue;
      values[k] = file_.accessor(index, where, {k == 1 ? "VEC4" : "VEC3"});
      if (count != 0 && values[k]->count != count) file_.refuse(where, "its instance attributes have different counts");
      count = values[k]->count;
    }
    for (size_t i = 0; i < count; ++i) {
      Transform transform;
      if (values[0]) transform.translation = values[0]->vector3(i);
      if (values[2]) transform.scale = values[2]->vector3(i);
      dvec4 q = values[1] ? values[1]->vector4(i) : dvec4(0, 0, 0, 1);
      double length = glm::length(q);
      transform.rotation = length > 0 ? dquat(q.w, q.x, q.y, q.z) / length : dquat(1, 0, 0, 0);
      dmat4 matrix = transform.matrix();
      double sum = 0;
      for (int c = 0; c < 4; ++c) sum += glm::dot(glm::abs(matrix[c]), dvec4(1));
      if (!std::isfinite(sum)) file_.refuse(where, fmt::format("its instance {} is not finite", i));
      node.instances.push_back(matrix);
    }
  }

  void readChildren(const Json& json, const std::string& where, int parent) {
    for (int index : file_.indexList(json, "children", "nodes", where)) {
      if (scene_.nodes[index].parent >= 0) file_.refuse(where, fmt::format("its child {} has another parent", index));
      scene_.nodes[index].parent = parent;
    }
  }

  // Reads the cuts of the shown scene. Nodes outside of this scene stay in the list, but show nothing.
  void readShownScene() {
    const Json& scenes = file_.all("scenes");
    if (scenes.empty()) return;
    int shown = std::max(0, file_.index(file_.json(), "scene", "scenes", ""));
    std::string where = fmt::format("scenes[{}]", shown);
    scene_.cuts = cutsOf(file_, scenes.at(shown), where);
    const std::vector<int> list = file_.indexList(scenes.at(shown), "nodes", "nodes", where);
    const std::set<int> roots(list.begin(), list.end());
    for (size_t i = 0; i < scene_.nodes.size(); ++i) {
      int node = int(i);
      while (node >= 0 && !roots.count(node)) node = scene_.nodes[node].parent;
      if (node >= 0) continue;
      Node& hidden = scene_.nodes[i];
      hidden.mesh = hidden.camera = hidden.light = -1;
    }
  }

  // --- the rest ---------------------------------------------------------------------------------------------------

  void warnOfUnusedExtensions() {
    for (const Json& name : file_.all("extensionsUsed")) {
      const std::string extension = name.get<std::string>();
      const std::vector<std::string>& known = supportedExtensions();
      if (std::find(known.begin(), known.end(), extension) == known.end())
        warn(fmt::format("extension {} is ignored", extension));
    }
  }

  void readAttribution() {
    const Json& asset = file_.object(file_.json(), "asset", "");
    scene_.attribution = Json::object();
    for (const char* key : {"copyright", "extras"})
      if (asset.contains(key)) scene_.attribution[key] = asset[key];
    Path beside = file_.path().parent_path() / "ATTRIBUTION.txt";
    std::error_code missing;
    bool small =
        std::filesystem::is_regular_file(beside, missing) && std::filesystem::file_size(beside, missing) < 65536;
    if (small && file_.mayRead(beside)) scene_.attribution["text"] = file_.readFile(beside);
  }

  GltfFile file_;
  std::string variant_;
  uint64_t most_bytes_ = UINT64_MAX;
  Scene scene_;
};

}  // namespace

Scene loadGltf(const Path& file, const GltfOptions& options) { return GltfLoader(file, options).load(); }

}  // namespace strobe::scene
