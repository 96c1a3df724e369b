// SPDX-License-Identifier: MIT
#include "scene/json_parts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

#include "base/lists.h"
#include "scene/motion.h"
#include "scene/textures.h"

namespace strobe::scene {

bool isKind(const Json& json, const std::string& kind) {
  return json.is_object() && json.contains("kind") && json["kind"] == kind;
}

static void appendContent(const Json& json, std::string& text) {
  const bool is_plain_list = json.is_array() && (json.empty() || json[0].is_number());
  if (!json.is_structured() || is_plain_list) {
    text += json.dump(-1, ' ', false, Json::error_handler_t::replace);
    return;
  }
  text += json.is_array() ? '[' : '{';
  if (json.is_array()) {
    for (const Json& item : json) appendContent(item, text), text += ',';
  } else {
    std::map<std::string_view, const Json*> sorted;
    for (const auto& [key, value] : json.items())
      if (key != "place") sorted.emplace(key, &value);
    for (const auto& [key, value] : sorted) {
      text += '"';
      text += key;
      text += "\":";
      appendContent(*value, text), text += ',';
    }
  }
  text += json.is_array() ? ']' : '}';
}

std::string contentOf(const Json& json) {
  std::string text;
  appendContent(json, text);
  return text;
}

static dquat lookingAt(SceneFields& fields, const dvec3& from, const dvec3& at) {
  dvec3 back = from - at;
  double length = glm::length(back);
  if (length == 0) {
    fields.problem("'look_at' equals 'position'");
    return dquat(1, 0, 0, 0);
  }
  back /= length;
  dvec3 up = std::abs(back.y) > 1 - 1e-9 ? dvec3(0, 0, -1) : dvec3(0, 1, 0);
  dvec3 right = glm::normalize(glm::cross(up, back));
  return glm::quat_cast(dmat3(right, glm::cross(back, right), back));
}

Transform readTransform(SceneFields& fields) {
  Transform transform;
  transform.translation = fields.vector3("position", dvec3(0));
  dvec3 turn = glm::radians(fields.vector3("rotation", dvec3(0)));
  transform.rotation = glm::angleAxis(turn.y, dvec3(0, 1, 0)) * glm::angleAxis(turn.x, dvec3(1, 0, 0)) *
                       glm::angleAxis(turn.z, dvec3(0, 0, 1));
  const Json* scale = fields.find("scale");
  if (scale && scale->is_number()) transform.scale = dvec3(fields.number("scale", 1));
  else if (scale) transform.scale = fields.vector3("scale", dvec3(1));
  if (fields.has("look_at")) {
    if (fields.has("rotation")) fields.problem("has both 'rotation' and 'look_at'");
    transform.rotation = lookingAt(fields, transform.translation, fields.vector3("look_at", std::nullopt));
  }
  return transform;
}

// --- shapes -------------------------------------------------------------------------------------------------------

static int segmentsOf(SceneFields& f, int fallback, int min = 3) { return f.integer("segments", fallback, min, 2048); }

static Shape readQuad(SceneFields& f) {
  dvec2 size = f.vector2("size", dvec2(1), 1e-9);
  int segments = segmentsOf(f, 1, 1);
  return quad(size, ivec2(segments), f.number("tile", 0, 0));
}

static Shape readBox(SceneFields& f) {
  dvec3 size = f.vector3("size", dvec3(1), 1e-9);
  double radius = f.number("radius", 0, 0);
  return box(size, radius, f.integer("segments", 3, 1, 64), f.number("tile", 0, 0));
}

static Shape readSphere(SceneFields& f) { return sphere(f.number("radius", 0.5, 1e-9), segmentsOf(f, 32)); }

static Shape readTorus(SceneFields& f) {
  double radius = f.number("radius", 0.5, 1e-9), tube_radius = f.number("tube_radius", 0.1, 1e-9);
  return torus(radius, tube_radius, segmentsOf(f, 48), f.integer("tube_segments", 16, 3, 512));
}

static Shape readSuperellipsoid(SceneFields& f) {
  dvec3 size = f.vector3("size", dvec3(1), 1e-9);
  return superellipsoid(size, f.number("north", 1, 0.02, 2), f.number("east", 1, 0.02, 2), segmentsOf(f, 32));
}

static Shape readLathe(SceneFields& f) {
  std::vector<dvec2> profile;
  for (const auto& row : f.rows("profile", 2, 2, 4096)) {
    if (row[0] < 0) f.problem(fmt::format("'profile' has radius {}; a radius must not be negative", row[0]));
    profile.push_back({row[0], row[1]});
  }
  int segments = segmentsOf(f, 48), smooth = f.integer("smooth", 1, 1, 64);
  double crease = f.number("crease", 40, 0, 180);
  return profile.empty() ? Shape() : lathe(profile, segments, smooth, crease);
}

static Shape readCylinder(SceneFields& f) {
  double radius = f.number("radius", 0.5, 0), top = f.number("top_radius", radius, 0);
  if (radius + top <= 0) f.problem("'radius' and 'top_radius' are both 0");
  double height = f.number("height", 1, 1e-9);
  return cylinder(radius, top, height, segmentsOf(f, 48), f.number("bevel", 0, 0));
}

static Shape readTube(SceneFields& f) {
  std::vector<dvec3> path;
  for (const auto& row : f.rows("path", 3, 2, 4096)) path.push_back({row[0], row[1], row[2]});
  std::vector<double> radii;
  if (f.has("radii")) radii = f.numbers("radii", path.size(), path.size());
  else radii.assign(path.size(), f.number("radius", 0.05, 1e-9));
  int segments = segmentsOf(f, 12), smooth = f.integer("smooth", 1, 1, 64);
  double flatten = f.number("flatten", 1, 1e-3, 1);
  dvec3 up = f.vector3("up", dvec3(0, 1, 0));
  if (glm::length(up) == 0) f.problem("'up' is 0, 0, 0");
  for (size_t i = 1; i < path.size(); ++i)
    if (path[i] == path[i - 1]) f.problem(fmt::format("point {} of 'path' equals the point before it", i + 1));
  return path.empty() || radii.empty() || glm::length(up) == 0 ? Shape()
                                                               : tube(path, radii, segments, smooth, flatten, up);
}

static Shape readCushion(SceneFields& f) {
  dvec3 size = f.vector3("size", dvec3(0.5, 0.5, 0.16), 1e-9);
  double pinch = f.number("pinch", 0.06, 0, 0.5);
  int quilt = f.integer("quilt", 0, 0, 64);
  double depth = f.number("quilt_depth", 0.15, 0, 0.9);
  return cushion(size, pinch, quilt, depth, segmentsOf(f, 32, 4));
}

static Shape readCloth(SceneFields& f) {
  dvec3 size = f.vector3("size", dvec3(1, 2, 0.1), 1e-9);
  double folds = f.number("folds", 6, 0, 500), flare = f.number("flare", 0.3, 0, 1);
  double thickness = f.number("thickness", 0.004, 1e-9);
  return cloth(size, folds, flare, thickness, {segmentsOf(f, 96), f.integer("segments_down", 12, 1, 2048)});
}

static Shape readTriangles(SceneFields& f) {
  std::vector<dvec3> positions, normals;
  std::vector<dvec2> uvs;
  std::vector<uint32_t> indices;
  constexpr size_t kMost = 1000000;
  for (const auto& row : f.rows("positions", 3, 3, kMost)) positions.push_back({row[0], row[1], row[2]});
  for (const auto& row : f.rows("normals", 3, 0, kMost)) normals.push_back({row[0], row[1], row[2]});
  for (const auto& row : f.rows("uvs", 2, 0, kMost)) uvs.push_back({row[0], row[1]});
  if (!normals.empty() && normals.size() != positions.size())
    f.problem("'normals' and 'positions' have different lengths");
  if (!uvs.empty() && uvs.size() != positions.size()) f.problem("'uvs' and 'positions' have different lengths");
  bool listed = f.has("indices");
  for (double index : f.numbers("indices", listed ? 3 : 0, 3 * kMost)) {
    bool valid = index >= 1 && index <= double(positions.size()) && index == std::floor(index);
    if (!valid) f.problem(fmt::format("'indices' has {}; positions are numbered 1 to {}", index, positions.size()));
    if (!valid) return {};
    indices.push_back(uint32_t(index) - 1);
  }
  for (size_t i = 0; !listed && i < positions.size(); ++i) indices.push_back(uint32_t(i));
  if (indices.size() % 3 != 0)
    f.problem(fmt::format("the number of corners is {}, not a multiple of 3", indices.size()));
  bool fits =
      (normals.empty() || normals.size() == positions.size()) && (uvs.empty() || uvs.size() == positions.size());
  return fits ? triangles(positions, normals, uvs, indices) : Shape();
}

static std::string typeOf(const Json& json) {
  return json.is_object() && json.contains("type") && json["type"].is_string() ? json["type"].get<std::string>() : "";
}

Shape readShape(const Json& json, const Place& place, Problems& problems) {
  using Reader = Shape (*)(SceneFields&);
  static const std::map<std::string, Reader> readers = {
      {"quad", readQuad},          {"box", readBox},
      {"sphere", readSphere},      {"torus", readTorus},
      {"lathe", readLathe},        {"tube", readTube},
      {"cylinder", readCylinder},  {"superellipsoid", readSuperellipsoid},
      {"cushion", readCushion},    {"cloth", readCloth},
      {"triangles", readTriangles}};
  std::string type = typeOf(json);
  auto reader = readers.find(type);
  SceneFields fields(json, reader == readers.end() ? "shape" : type, place, problems);
  if (!isKind(json, "shape") || reader == readers.end()) {
    fields.problem("is not a shape; write scene.box { ... } or another shape of strobe.scene");
    return {};
  }
  Shape shape = reader->second(fields);
  fields.finish();
  return shape;
}

// --- textures -----------------------------------------------------------------------------------------------------

static Texture readTexels(SceneFields& f) {
  int width = f.integer("width", std::nullopt, 1, 16384), height = f.integer("height", 1, 1, 16384);
  std::vector<vec4> texels;
  for (const auto& row : f.rows("texels", 3, 1, size_t(1) << 24, 4, 3.4e38))
    texels.push_back(vec4(row[0], row[1], row[2], row.size() > 3 ? row[3] : 1));
  if (texels.size() != size_t(width) * height) {
    f.problem(fmt::format("{} texels do not fill {} x {}", texels.size(), width, height));
    return {};
  }
  return texelTexture(width, height, texels);
}

static Texture readPattern(SceneFields& f, const std::string& type, const Painter& paint) {
  Pattern pattern;
  pattern.type = type;
  dvec2 size = f.vector2("size", dvec2(512), 1, 4096);
  pattern.width = int(size.x);
  pattern.height = int(size.y);
  for (const auto& row : f.rows("colors", 3, 1, 64, 4)) pattern.colors.push_back(vec3(row[0], row[1], row[2]));
  if (pattern.colors.size() < patternColors(type)) {
    f.problem(fmt::format("'colors' needs at least {} colours", patternColors(type)));
    pattern.colors.resize(patternColors(type), vec3(0.5));
  }
  const Json* count = f.find("count");
  if (count && count->is_number()) pattern.count = dvec2(f.number("count", 8, 0, 4096));
  else pattern.count = f.vector2("count", dvec2(8), 0, 4096);
  pattern.widths = f.numbers("widths", 0, 64);
  for (double width : pattern.widths)
    if (width <= 0) f.problem(fmt::format("'widths' has {}; a width must be above 0", width));
  pattern.amount = f.number("amount", 0.5, 0, 1);
  pattern.line = f.number("line", 0.06, 0, 1);
  pattern.seed = f.integer("seed", 1, 0, 1000000);
  return paint(pattern);
}

static Texture readImage(SceneFields& fields, SceneFiles& files) {
  const std::string name = fields.text("file", std::nullopt);
  return name.empty() ? Texture() : files.image(name, fields).value_or(Texture());
}

Texture readTexture(const Json& json, const Place& place, Problems& problems, const Painter& paint, SceneFiles& files) {
  std::string type = typeOf(json);
  const bool pattern = contains(patternNames(), type);
  SceneFields fields(json, type.empty() ? "texture" : "texture " + type, place, problems);
  if (!isKind(json, "texture") || !(pattern || type == "texels" || type == "image")) {
    fields.problem("is not a texture; write scene.texture.stripes { ... } or another texture of strobe.scene");
    return {};
  }
  std::string wrap = fields.choice("wrap", "repeat", {"repeat", "mirror", "clamp"});
  Texture texture = pattern           ? readPattern(fields, type, paint)
                    : type == "image" ? readImage(fields, files)
                                      : readTexels(fields);
  texture.name = fields.text("name", type);
  texture.wrap_u = wrap == "repeat"   ? Texture::Wrap::Repeat
                   : wrap == "mirror" ? Texture::Wrap::Mirror
                                      : Texture::Wrap::Clamp;
  texture.wrap_v = texture.wrap_u;
  if (fields.choice("filter", "linear", {"linear", "nearest"}) == "nearest") {
    texture.magnify = texture.minify = Texture::Filter::Nearest;
    texture.between = Texture::Levels::None;
  }
  fields.finish();
  return texture;
}

// --- lights and cameras -------------------------------------------------------------------------------------------

Light readLight(const Json& json, const Place& place, Problems& problems) {
  SceneFields fields(json, "light", place, problems);
  Light light;
  if (!isKind(json, "light")) {
    fields.problem("is not a light; write scene.point_light { ... }, scene.spot_light or scene.directional_light");
    return light;
  }
  std::string type = typeOf(json);
  light.type = type == "spot"          ? Light::Type::Spot
               : type == "directional" ? Light::Type::Directional
                                       : Light::Type::Point;
  light.name = fields.text("name");
  light.color = vec3(fields.color("color", vec4(1)));
  light.intensity = fields.number("intensity", 1, 0, 1e30);
  light.shadow = fields.boolean("shadow", true);
  if (light.type != Light::Type::Directional) light.range = fields.number("range", 0, 0);
  if (light.type == Light::Type::Spot) {
    light.outer_cone = glm::radians(fields.number("outer_cone", 45, 0, 90));
    light.inner_cone = glm::radians(fields.number("inner_cone", 0, 0, 90));
    if (light.inner_cone > light.outer_cone) fields.problem("'inner_cone' is wider than 'outer_cone'");
  }
  fields.finish();
  return light;
}

Camera readCamera(const Json& json, const Place& place, Problems& problems) {
  SceneFields fields(json, "camera", place, problems);
  Camera camera;
  if (!isKind(json, "camera")) {
    fields.problem("is not a camera; write scene.camera { ... } or scene.orthographic_camera { ... }");
    return camera;
  }
  camera.name = fields.text("name");
  camera.orthographic = typeOf(json) == "orthographic";
  camera.near = fields.number("near", 0.01, 1e-30);
  if (camera.orthographic) camera.half_height = fields.number("half_height", std::nullopt, 1e-9);
  else camera.vertical_fov = glm::radians(fields.number("fov", 45, 0.01, 175));
  fields.finish();
  return camera;
}

}  // namespace strobe::scene
