// SPDX-License-Identifier: MIT
#include "scene/json_scene.h"

#include <algorithm>
#include <functional>
#include <map>

#include "scene/attach.h"
#include "scene/clips.h"
#include "scene/gltf.h"
#include "scene/gltf_parts.h"
#include "scene/json_parts.h"
#include "scene/motion.h"

namespace strobe::scene {

namespace {

constexpr size_t kMostNodes = 100000;
constexpr size_t kMostSceneVertices = 20000000;
constexpr int kDeepest = 100;

class SceneBuilder {
 public:
  SceneBuilder(const std::string& file, const std::vector<Suggestion>& suggestions, const Painter& paint,
               const std::optional<FilePlaces>& places)
      : file_{file},
        suggestions_(suggestions),
        paint_(paint),
        files_(places ? *places : FilePlaces{Path(file).parent_path()}) {}

  Scene build(const Json& json) {
    SceneFields fields(json, "scene", file_, problems_);
    if (!isKind(json, "scene")) fields.problem("a scene file must return scene { ... } of strobe.scene");
    scene_.materials.push_back(plain());
    scene_.name = fields.text("name", file_.file);
    if (const Json* shot = fields.find("shot")) checkShot(*shot, fields.place());
    if (const Json* environment = fields.find("environment")) readEnvironment(*environment, fields.place());
    if (const Json* nodes = fields.need("nodes")) readNodes(*nodes, -1, fields, 0);
    for (const auto& attach : attached_) attach();
    if (const Json* animations = fields.find("animations"))
      for (const Json& animation : listIn(*animations, "animations", fields)) readAnimation(animation, fields.place());
    scene_.cuts = readCuts(fields);
    scene_.loop_s = fields.number("loop", 0, 0, 1e6);
    fields.finish();
    problems_.throwIfAny();
    yieldClips(scene_);
    findSoleJoints(scene_);
    scene_.files = files_.read();
    return std::move(scene_);
  }

 private:
  static Material plain() {
    Material material;
    material.name = "default";
    material.base_color = vec4(0.6f, 0.6f, 0.6f, 1);
    return material;
  }

  // List in a table. Empty, with a mistake, if the member is not a list; a table with string keys is not a list.
  const Json& listIn(const Json& json, const std::string& key, SceneFields& fields) {
    static const Json kNone = Json::array();
    bool empty = json.is_structured() && json.empty();
    if (json.is_array() || empty) return json.is_array() ? json : kNone;
    fields.problem(fmt::format("'{}' must be a list", key));
    return kNone;
  }

  // Checks the values that the scene suggests for its pictures. The values are read from the description later.
  void checkShot(const Json& json, const Place& outer) {
    SceneFields fields(json, "shot", outer, problems_);
    for (const Suggestion& one : suggestions_) {
      if (one.whole) fields.integer(one.name, int(one.min), int(one.min), int(one.max));
      else fields.number(one.name, one.min, one.min, one.max);
    }
    fields.finish();
  }

  // Times of cuts, s.
  std::vector<double> readCuts(SceneFields& fields) {
    if (!fields.has("cuts")) return {};
    std::vector<double> cuts = fields.numbers("cuts", 1, 100000);
    if (!increase(cuts)) fields.problem("'cuts' do not increase");
    return cuts;
  }

  void readEnvironment(const Json& json, const Place& outer) {
    SceneFields fields(json, "environment", outer, problems_);
    scene_.environment.sky = vec3(fields.color("sky", vec4(0), 1e6));
    scene_.environment.ground = vec3(fields.color("ground", vec4(scene_.environment.sky, 1), 1e6));
    if (fields.has("background")) scene_.environment.background = vec3(fields.color("background", std::nullopt, 1e6));
    fields.finish();
  }

  void readNodes(const Json& json, int parent, SceneFields& outer, int depth) {
    std::string key = parent < 0 ? "nodes" : "children";
    if (depth > kDeepest) return outer.problem(fmt::format("'{}' are nested deeper than {} levels", key, kDeepest));
    for (const Json& node : listIn(json, key, outer)) {
      if (scene_.nodes.size() >= kMostNodes)
        return outer.problem(fmt::format("the scene has more than {} nodes", kMostNodes));
      readNode(node, parent, outer.place(), depth);
    }
  }

  void readNode(const Json& json, int parent, const Place& outer, int depth) {
    SceneFields fields(json, "node", outer, problems_);
    if (!isKind(json, "node")) return fields.problem("is not a node; write scene.node { ... }");
    int index = int(scene_.nodes.size());
    Node node;
    node.parent = parent;
    node.name = fields.text("name", fmt::format("node_{}", index));
    fields.rename(fmt::format("node '{}'", node.name));
    if (!names_.emplace(node.name, index).second) fields.problem("another node has this name");
    node.transform = readTransform(fields);
    node.mesh = readMesh(fields, json, node.name);
    if (const Json* light = fields.find("light")) {
      node.light = int(scene_.lights.size());
      scene_.lights.push_back(readLight(*light, fields.place(), problems_));
      if (scene_.lights.back().name.empty()) scene_.lights.back().name = node.name;
    }
    if (const Json* camera = fields.find("camera")) {
      node.camera = int(scene_.cameras.size());
      scene_.cameras.push_back(readCamera(*camera, fields.place(), problems_));
      if (scene_.cameras.back().name.empty()) scene_.cameras.back().name = node.name;
    }
    if (const Json* motion = fields.find("motion")) readMotion(*motion, index, fields);
    node.cuts = readCuts(fields);
    if (const Json* gltf = fields.find("gltf")) readGltf(*gltf, index, fields.place());
    scene_.nodes.push_back(std::move(node));
    if (const Json* children = fields.find("children")) readNodes(*children, index, fields, depth + 1);
    fields.finish();
  }

  // Stores a glTF file for attachment after all nodes of the description, so that the first camera is the
  // description's.
  void readGltf(const Json& json, int node, const Place& outer) {
    SceneFields fields(json, "gltf", outer, problems_);
    if (!isKind(json, "gltf")) return fields.problem("is not a glTF file; write scene.gltf { ... }");
    const std::string name = fields.text("file", std::nullopt), animation = fields.text("animation", "all");
    const GltfOptions options{files_.allowOutside(), fields.text("variant", "")};
    const Place place = fields.place();
    fields.finish();
    const std::optional<Path> file = name.empty() ? std::nullopt : files_.find(name, fields);
    if (!file) return;
    const std::string key = file->string() + "\n" + options.variant;
    attached_.push_back([this, file = *file, options, key, node, animation, place] {
      try {
        if (!parts_.contains(key)) parts_.emplace(key, addedPart(loadGltf(file, options), scene_));
        attachPart(parts_.at(key), node, animation);
      } catch (const Error& error) {
        problems_.add(place, fmt::format("gltf: {}", error.what()));
      }
    });
  }

  void attachPart(const AttachedPart& part, int node, const std::string& animation) {
    const size_t first = scene_.nodes.size();
    attach(part, node, animation, scene_);
    for (const SourceFile& file : part.scene.files) files_.add(file);
    for (size_t i = first; i < scene_.nodes.size(); ++i)
      if (!names_.emplace(scene_.nodes[i].name, int(i)).second)
        throw Error(fmt::format("another node is called '{}'", scene_.nodes[i].name));
  }

  void readMotion(const Json& json, int node, SceneFields& outer) {
    SceneFields fields(json, "motion", outer.place(), problems_);
    ConstantMotion motion;
    motion.node = node;
    motion.velocity = fields.vector3("velocity", dvec3(0));
    dvec3 axis = fields.vector3("axis", dvec3(0, 1, 0));
    if (glm::length(axis) == 0) fields.problem("'axis' is 0, 0, 0");
    else motion.axis = glm::normalize(axis);
    motion.angular_velocity = glm::radians(fields.number("degrees_per_second", 0));
    motion.rest_time = fields.number("rest_time", 0);
    fields.finish();
    scene_.motions.push_back(motion);
  }

  // Reads `shape` and `material`, or `parts` for several; -1 without a shape. Shapes of a part may have their own
  // placement.
  int readMesh(SceneFields& fields, const Json& json, const std::string& name) {
    const Json *shape = fields.find("shape"), *material = fields.find("material"), *parts = fields.find("parts");
    if (material && !shape) fields.problem("has 'material' but no 'shape'");
    if (shape && parts) fields.problem("has both 'shape' and 'parts'");
    if (!shape && !parts) return -1;
    Json key = parts ? *parts : Json::array({*shape, material ? *material : Json()});
    auto [known, is_new] = meshes_.emplace(contentOf(key), int(scene_.meshes.size()));
    if (!is_new) return known->second;

    std::vector<MeshPart> made;
    if (shape) made.push_back({readShape(*shape, fields.place(), problems_), materialIndex(material, fields.place())});
    if (parts)
      for (const Json& part : listIn(json["parts"], "parts", fields)) made.push_back(readPart(part, fields.place()));
    for (const MeshPart& part : made) vertices_ += part.shape.points.size();
    if (vertices_ > kMostSceneVertices) {
      fields.problem(fmt::format("the scene has more than {} vertices", kMostSceneVertices));
      made.clear();
    }
    scene_.meshes.push_back(meshOf(name, made));
    return known->second;
  }

  MeshPart readPart(const Json& json, const Place& outer) {
    SceneFields fields(json, "part", outer, problems_);
    MeshPart part;
    const Json* shape = fields.need("shape");
    part.material = materialIndex(fields.find("material"), fields.place());
    const Transform at = readTransform(fields);
    fields.finish();
    if (!shape) return part;
    part.shape = transformed(readShape(*shape, fields.place(), problems_), at.matrix());
    return part;
  }

  int materialIndex(const Json* json, const Place& outer) {
    if (!json || json->is_null()) return 0;
    auto [known, is_new] = materials_.emplace(contentOf(*json), int(scene_.materials.size()));
    if (!is_new) return known->second;
    scene_.materials.push_back(readMaterial(*json, outer));
    return known->second;
  }

  Material readMaterial(const Json& json, const Place& outer) {
    SceneFields fields(json, "material", outer, problems_);
    Material material;
    if (!isKind(json, "material")) {
      fields.problem("is not a material; write scene.material { ... }");
      return material;
    }
    material.name = fields.text("name");
    if (!material.name.empty()) fields.rename(fmt::format("material '{}'", material.name));
    material.base_color = fields.color("color", vec4(1), 1e6);
    material.metallic = float(fields.number("metallic", 0, 0, 1));
    material.roughness = float(fields.number("roughness", 0.7, 0, 1));
    material.normal_scale = float(fields.number("normal_scale", 1, -100, 100));
    material.emissive = vec3(fields.color("emissive", vec4(0), 1e6));
    material.unlit = fields.boolean("unlit", false);
    if (fields.has("alpha_cutoff")) material.alpha = Material::Alpha::Mask;
    material.alpha_cutoff = float(fields.number("alpha_cutoff", 0.5, 0, 1));
    if (fields.boolean("blend", false)) {
      if (material.alpha == Material::Alpha::Mask) fields.problem("has both 'alpha_cutoff' and 'blend'");
      material.alpha = Material::Alpha::Blend;
    }
    material.double_sided = fields.boolean("double_sided", true);
    material.base_color_texture = readUse(fields, "color_texture", true);
    material.emissive_texture = readUse(fields, "emissive_texture", true);
    material.metallic_roughness_texture = readUse(fields, "metallic_roughness_texture", false);
    material.normal_texture = readUse(fields, "normal_texture", false);
    fields.finish();
    return material;
  }

  // Reads a texture, or scene.use { texture = ... } with its placement. Textures without colours are stored unchanged.
  TextureUse readUse(SceneFields& outer, const std::string& key, bool is_color) {
    TextureUse use;
    const Json* json = outer.find(key);
    if (!json) return use;
    if (!isKind(*json, "use")) {
      use.texture = textureIndex(*json, outer.place(), is_color);
      return use;
    }
    SceneFields fields(*json, "use", outer.place(), problems_);
    const Json* texture = fields.need("texture");
    dvec2 scale = fields.vector2("scale", dvec2(1)), offset = fields.vector2("offset", dvec2(0));
    double rotation = glm::radians(fields.number("rotation", 0));
    fields.finish();
    if (texture) use.texture = textureIndex(*texture, fields.place(), is_color);
    use.uv_transform = uvTransform(offset, rotation, scale);
    return use;
  }

  int textureIndex(const Json& json, const Place& outer, bool is_color) {
    auto [known, is_new] = textures_.emplace(contentOf(json) + (is_color ? "" : "#"), int(scene_.textures.size()));
    if (!is_new) return known->second;
    Texture texture = readTexture(json, outer, problems_, paint_, files_);
    if (!is_color && texture.format == Texture::Format::Rgba8Srgb) texture.format = Texture::Format::Rgba8Unorm;
    if (texture.levels.size() == 1 && texture.format != Texture::Format::Rgba32f) buildLevels(texture);
    scene_.textures.push_back(std::move(texture));
    return known->second;
  }

  void readAnimation(const Json& json, const Place& outer) {
    SceneFields fields(json, "animation", outer, problems_);
    if (!isKind(json, "animation")) return fields.problem("is not an animation; write scene.animation { ... }");
    Animation animation;
    animation.name = fields.text("name", std::nullopt);
    fields.rename(fmt::format("animation '{}'", animation.name));
    for (const Animation& other : scene_.animations)
      if (other.name == animation.name) fields.problem("another animation has this name");
    const Json* tracks = fields.need("tracks");
    if (tracks)
      for (const Json& track : listIn(*tracks, "tracks", fields)) readTrack(track, fields.place(), animation);
    animation.duration = fields.number("duration", animation.duration, animation.duration);
    fields.finish();
    scene_.animations.push_back(std::move(animation));
  }

  void readTrack(const Json& json, const Place& outer, Animation& animation) {
    SceneFields fields(json, "track", outer, problems_);
    if (!isKind(json, "track")) return fields.problem("is not a track; write scene.track { ... }");
    Track track;
    std::string name = fields.text("node", std::nullopt);
    auto node = names_.find(name);
    if (node != names_.end()) track.object = node->second;
    else fields.problem(fmt::format("unknown node '{}'{}", name, didYouMean(name, nodeNames())));
    std::string target = fields.choice("target", "translation", {"translation", "rotation", "scale"});
    track.target = target == "translation" ? Track::Target::Translation
                   : target == "rotation"  ? Track::Target::Rotation
                                           : Track::Target::Scale;
    std::string how = fields.choice("interpolation", "linear", {"linear", "step", "cubic"});
    track.interpolation = how == "linear" ? Track::Interpolation::Linear
                          : how == "step" ? Track::Interpolation::Step
                                          : Track::Interpolation::CubicSpline;
    track.times = fields.numbers("times", 1, 100000);
    size_t components = target == "rotation" ? 4 : 3;
    for (const auto& row : fields.rows("values", components, 1, 300000))
      track.values.push_back(dvec4(row[0], row[1], row[2], components == 4 ? row[3] : 0));
    fields.finish();
    if (track.times.empty()) return;  // reported as missing
    for (size_t i = 1; i < track.times.size(); ++i)
      if (!(track.times[i] > track.times[i - 1])) return fields.problem("'times' do not increase");
    size_t wanted = track.times.size() * (how == "cubic" ? 3 : 1);
    if (track.values.size() != wanted)
      return fields.problem(
          fmt::format("{} times need {} values, got {}", track.times.size(), wanted, track.values.size()));
    for (const Track& other : animation.tracks)
      if (other.object == track.object && other.target == track.target)
        return fields.problem(fmt::format("another track drives the {} of node '{}'", target, name));
    if (track.object >= 0) splitMatrix(scene_.nodes[size_t(track.object)]);
    animation.duration = std::max(animation.duration, track.times.back());
    animation.tracks.push_back(std::move(track));
  }

  std::vector<std::string> nodeNames() const {
    std::vector<std::string> names;
    for (const auto& [name, index] : names_) names.push_back(name);
    return names;
  }

  Place file_;
  const std::vector<Suggestion>& suggestions_;
  const Painter& paint_;
  Problems problems_;
  SceneFiles files_;
  Scene scene_;
  std::map<std::string, AttachedPart> parts_;    // glTF files, by file and variant
  std::vector<std::function<void()>> attached_;  // one call per node with a glTF file
  std::map<std::string, int> names_, meshes_, materials_, textures_;
  size_t vertices_ = 0;
};

}  // namespace

Scene sceneFromJson(const Json& description, const std::string& file, const std::vector<Suggestion>& suggestions,
                    const Painter& paint, const std::optional<FilePlaces>& places) {
  return SceneBuilder(file, suggestions, paint, places).build(description);
}

void checkScene(const Json& description, const std::string& file, const std::vector<Suggestion>& suggestions,
                const std::optional<FilePlaces>& places) {
  const Painter of_one_texel = [](Pattern pattern) {
    pattern.width = pattern.height = 1;
    return paintPattern(pattern);
  };
  SceneBuilder(file, suggestions, of_one_texel, places).build(description);
}

}  // namespace strobe::scene
