// SPDX-License-Identifier: MIT
#include "scene/gltf.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "scene/defaults.h"
#include "scene/gltf_animation.h"
#include "scene/gltf_mesh.h"
#include "scene/motion.h"
#include "scene/textures.h"

namespace strobe::scene {

namespace {

const std::vector<std::string> kSupported = {
    "KHR_lights_punctual",   "KHR_materials_unlit",     "KHR_texture_transform", "KHR_materials_emissive_strength",
    "KHR_mesh_quantization", "EXT_mesh_gpu_instancing", "KHR_materials_variants"};

class Loader {
 public:
  Loader(const Path& path, bool allow_outside) : file_(path, kSupported, allow_outside) {}

  Scene load() {
    scene_.name = file_.path().stem().string();
    readMaterials();
    for (size_t i = 0; i < file_.all("meshes").size(); ++i)
      scene_.meshes.push_back(readMesh(file_, int(i), int(scene_.materials.size()) - 1, scene_.warnings));
    readCameras();
    readLights();
    readNodes();
    keepReachable();
    readAnimations(file_, scene_);
    hierarchyOrder(scene_);
    warnOfUnusedExtensions();
    readAttribution();
    moderateLights(scene_);
    scene_.files = file_.files();
    return std::move(scene_);
  }

 private:
  void warn(const std::string& text) { scene_.warnings.push_back(text); }

  // --- materials --------------------------------------------------------------------------------------------------

  void readMaterials() {
    const Json& materials = file_.all("materials");
    for (size_t i = 0; i < materials.size(); ++i)
      scene_.materials.push_back(readMaterial(materials[i], fmt::format("materials[{}]", i)));
    // Of primitives that name no material: glTF's is a white metal, which lamps alone would leave black.
    Material plain;
    plain.name = "default";
    plain.base_color = vec4(0.8f, 0.8f, 0.8f, 1);
    scene_.materials.push_back(plain);
  }

  Material readMaterial(const Json& json, const std::string& where) {
    Material material;
    material.name = file_.text(json, "name");
    const Json& pbr = file_.object(json, "pbrMetallicRoughness", where);
    auto color = file_.numbers(pbr, "baseColorFactor", {1, 1, 1, 1}, where);
    material.base_color = vec4(color[0], color[1], color[2], color[3]);
    material.metallic = float(std::clamp(file_.number(pbr, "metallicFactor", 1, where), 0.0, 1.0));
    material.roughness = float(std::clamp(file_.number(pbr, "roughnessFactor", 1, where), 0.0, 1.0));
    material.base_color_texture = readUse(pbr, "baseColorTexture", true, where);
    material.metallic_roughness_texture = readUse(pbr, "metallicRoughnessTexture", false, where);
    material.normal_texture = readUse(json, "normalTexture", false, where);
    material.normal_scale = float(file_.number(file_.object(json, "normalTexture", where), "scale", 1, where));
    material.emissive_texture = readUse(json, "emissiveTexture", true, where);
    auto emissive = file_.numbers(json, "emissiveFactor", {0, 0, 0}, where);
    const Json& strength = file_.extension(json, "KHR_materials_emissive_strength");
    material.emissive =
        vec3(emissive[0], emissive[1], emissive[2]) * float(file_.number(strength, "emissiveStrength", 1, where));
    file_.extension(json, "KHR_materials_unlit", &material.unlit);
    readAlpha(json, where, material);
    return material;
  }

  void readAlpha(const Json& json, const std::string& where, Material& material) {
    std::string mode = file_.text(json, "alphaMode");
    if (mode.empty() || mode == "OPAQUE") return;
    if (mode != "MASK" && mode != "BLEND") file_.refuse(where, fmt::format("alphaMode '{}' is unknown", mode));
    material.alpha_mask = true;
    material.alpha_cutoff = mode == "MASK" ? float(file_.number(json, "alphaCutoff", 0.5, where)) : 0.5f;
    if (mode == "BLEND")
      warn(fmt::format("{} '{}': blending is shown as a cut-out at alpha 0.5", where, material.name));
  }

  TextureUse readUse(const Json& owner, const char* key, bool is_color, const std::string& where) {
    TextureUse use;
    const Json& info = file_.object(owner, key, where);
    int texture = file_.index(info, "index", "textures", where);
    if (texture < 0) return use;
    size_t set = file_.size(info, "texCoord", 0, where);
    const Json& transform = file_.extension(info, "KHR_texture_transform");
    auto offset = file_.numbers(transform, "offset", {0, 0}, where);
    auto scale = file_.numbers(transform, "scale", {1, 1}, where);
    set = file_.size(transform, "texCoord", set, where);
    use.uv_transform =
        uvTransform({offset[0], offset[1]}, file_.number(transform, "rotation", 0, where), {scale[0], scale[1]});
    if (set > 1) warn(fmt::format("{}: {} uses texture coordinates {}; 0 serve instead", where, key, set));
    use.uv_set = set == 1 ? 1 : 0;
    use.texture = textureIndex(texture, is_color);
    return use;
  }

  Texture::Wrap wrapOf(const Json& sampler, const char* key, const std::string& where) {
    size_t mode = file_.size(sampler, key, 10497, where);
    if (mode != 10497 && mode != 33071 && mode != 33648)
      file_.refuse(where, fmt::format("{} {} is unknown", key, mode));
    return mode == 33071 ? Texture::Wrap::Clamp : mode == 33648 ? Texture::Wrap::Mirror : Texture::Wrap::Repeat;
  }

  int textureIndex(int texture, bool is_color) {
    const Json& json = file_.all("textures").at(texture);
    std::string where = fmt::format("textures[{}]", texture);
    int image = file_.index(json, "source", "images", where);
    if (image < 0) {
      warn(where + ": its image is of a kind that is not supported; it is left out");
      return -1;
    }
    int sampler_index = file_.index(json, "sampler", "samplers", where);
    const Json none = Json::object();
    const Json& sampler = sampler_index < 0 ? none : file_.all("samplers").at(sampler_index);
    Texture::Wrap u = wrapOf(sampler, "wrapS", where), v = wrapOf(sampler, "wrapT", where);
    auto [known, is_new] = textures_.emplace(std::tuple(image, u, v, is_color), int(scene_.textures.size()));
    if (is_new) scene_.textures.push_back(makeTexture(image, u, v, is_color));
    return known->second;
  }

  Texture makeTexture(int image, Texture::Wrap u, Texture::Wrap v, bool is_color) {
    auto decoded = images_.find(image);
    if (decoded == images_.end()) decoded = images_.emplace(image, file_.image(image)).first;
    Texture texture;
    texture.name = file_.text(file_.all("images").at(image), "name");
    if (texture.name.empty()) texture.name = fmt::format("image_{}", image);
    texture.format = is_color ? Texture::Format::Rgba8Srgb : Texture::Format::Rgba8Unorm;
    texture.width = decoded->second.width;
    texture.height = decoded->second.height;
    texture.levels = {decoded->second.rgba};
    texture.wrap_u = u;
    texture.wrap_v = v;
    buildLevels(texture);
    return texture;
  }

  // --- cameras and lights -----------------------------------------------------------------------------------------

  void readCameras() {
    const Json& cameras = file_.all("cameras");
    for (size_t i = 0; i < cameras.size(); ++i) {
      std::string where = fmt::format("cameras[{}]", i), type = file_.text(cameras[i], "type");
      Camera camera;
      camera.name = file_.text(cameras[i], "name");
      camera.orthographic = type == "orthographic";
      if (type != "orthographic" && type != "perspective")
        file_.refuse(where, fmt::format("type '{}' is unknown", type));
      const Json& lens = file_.object(cameras[i], type, where);
      camera.near = file_.number(lens, "znear", camera.orthographic ? 0 : 0.01, where);
      bool sensible_near = camera.orthographic ? camera.near >= 0 : camera.near > 0;
      if (!sensible_near) file_.refuse(where, fmt::format("znear is {}", camera.near));
      if (camera.orthographic) {
        camera.half_height = file_.number(lens, "ymag", 1, where);
        if (camera.half_height <= 0) file_.refuse(where, fmt::format("ymag is {}", camera.half_height));
        camera.aspect = file_.number(lens, "xmag", camera.half_height, where) / camera.half_height;
      } else {
        camera.vertical_fov = file_.number(lens, "yfov", 0.8, where);
        bool sensible = camera.vertical_fov > 1e-4 && camera.vertical_fov < 3.14;
        if (!sensible) file_.refuse(where, fmt::format("yfov is {} radians", camera.vertical_fov));
        if (lens.contains("aspectRatio")) camera.aspect = file_.number(lens, "aspectRatio", 1, where);
      }
      scene_.cameras.push_back(camera);
    }
  }

  void readLights() {
    const Json& lights = file_.list(file_.extension(file_.json(), "KHR_lights_punctual"), "lights", "");
    for (size_t i = 0; i < lights.size(); ++i) {
      std::string where = fmt::format("KHR_lights_punctual.lights[{}]", i), type = file_.text(lights[i], "type");
      Light light;
      light.name = file_.text(lights[i], "name");
      if (type == "directional") light.type = Light::Type::Directional;
      else if (type == "spot") light.type = Light::Type::Spot;
      else if (type != "point") file_.refuse(where, fmt::format("type '{}' is unknown", type));
      auto color = file_.numbers(lights[i], "color", {1, 1, 1}, where);
      light.intensity = vec3(color[0], color[1], color[2]) * float(file_.number(lights[i], "intensity", 1, where));
      light.range = std::max(0.0, file_.number(lights[i], "range", 0, where));
      const Json& spot = file_.object(lights[i], "spot", where);
      light.inner_cone = file_.number(spot, "innerConeAngle", 0, where);
      light.outer_cone = file_.number(spot, "outerConeAngle", 0.7853981633974483, where);
      scene_.lights.push_back(light);
    }
  }

  // --- nodes ------------------------------------------------------------------------------------------------------

  void readNodes() {
    const Json& nodes = file_.all("nodes");
    scene_.nodes.resize(nodes.size());
    std::set<std::string> taken;
    for (size_t i = 0; i < nodes.size(); ++i) {
      Node& node = scene_.nodes[i];
      std::string where = fmt::format("nodes[{}]", i);
      node.name = file_.uniqueName(nodes[i], fmt::format("node_{}", i), taken);
      readTransform(nodes[i], where, node);
      node.mesh = file_.index(nodes[i], "mesh", "meshes", where);
      node.camera = file_.index(nodes[i], "camera", "cameras", where);
      node.light = lightIndex(nodes[i], where);
      readInstancing(nodes[i], where, node);
      readChildren(nodes[i], where, int(i));
      if (node.camera >= 0 && scene_.cameras[node.camera].name.empty()) scene_.cameras[node.camera].name = node.name;
      warnOfMorphing(node);
    }
  }

  void warnOfMorphing(const Node& node) {
    if (node.mesh < 0) return;
    for (const Json& primitive : file_.list(file_.all("meshes").at(node.mesh), "primitives", "")) {
      if (file_.list(primitive, "targets", "").empty()) continue;
      return warn(fmt::format("node '{}': morph targets are not supported; its base mesh is shown", node.name));
    }
  }

  void readTransform(const Json& json, const std::string& where, Node& node) {
    auto t = file_.numbers(json, "translation", {0, 0, 0}, where), s = file_.numbers(json, "scale", {1, 1, 1}, where);
    auto r = file_.numbers(json, "rotation", {0, 0, 0, 1}, where);
    node.translation = {t[0], t[1], t[2]};
    node.scale = {s[0], s[1], s[2]};
    dquat rotation(r[3], r[0], r[1], r[2]);
    double length = glm::length(rotation);
    if (length == 0) file_.refuse(where, "its rotation is a quaternion of length 0");
    node.rotation = rotation / length;
    if (!json.contains("matrix")) return;
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
      if (count != 0 && values[k]->count != count) file_.refuse(where, "its instance attributes differ in number");
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
    for (const Json& child : file_.list(json, "children", where)) {
      Json holder = {{"child", child}};
      int index = file_.index(holder, "child", "nodes", where);
      if (scene_.nodes[index].parent >= 0) file_.refuse(where, fmt::format("its child {} has another parent", index));
      scene_.nodes[index].parent = parent;
    }
  }

  // Nodes that are not in the shown scene stay in the list, but show nothing.
  void keepReachable() {
    hierarchyOrder(scene_);
    const Json& scenes = file_.all("scenes");
    if (scenes.empty()) return;
    int shown = std::max(0, file_.index(file_.json(), "scene", "scenes", ""));
    std::set<int> roots;
    for (const Json& root : file_.list(scenes.at(shown), "nodes", "scenes")) {
      Json holder = {{"node", root}};
      roots.insert(file_.index(holder, "node", "nodes", fmt::format("scenes[{}]", shown)));
    }
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
      if (!name.is_string()) continue;
      std::string extension = name.get<std::string>();
      bool known = std::find(kSupported.begin(), kSupported.end(), extension) != kSupported.end();
      if (!known) warn(fmt::format("extension {} is ignored", extension));
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
  Scene scene_;
  std::map<int, Decoded> images_;
  std::map<std::tuple<int, Texture::Wrap, Texture::Wrap, bool>, int> textures_;
};

}  // namespace

Scene loadGltf(const Path& file, bool allow_outside) { return Loader(file, allow_outside).load(); }

}  // namespace strobe::scene
