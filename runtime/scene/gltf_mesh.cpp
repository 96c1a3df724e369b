// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>

#include "scene/gltf_parts.h"
#include "scene/shapes.h"

namespace strobe::scene {

namespace {

// Positions beyond this overflow squared lengths in single precision.
constexpr double kFarthest = 1e18;

struct Primitive {
  std::vector<dvec3> positions;
  std::vector<Vertex> vertices;  // without the positions
  std::vector<uint32_t> indices;
  bool has_normals = false;
  std::vector<vec4> tangents;
  int material = 0;
  Influences influences;
  std::vector<MorphTarget> targets;
};

// Elements of a list for the given vertices, `width` per vertex. Empty for an empty list.
template <class T>
std::vector<T> picked(const std::vector<T>& list, const std::vector<uint32_t>& vertices, size_t width) {
  std::vector<T> result;
  for (size_t i = 0; i < vertices.size() && !list.empty(); ++i)
    result.insert(result.end(), list.begin() + std::ptrdiff_t(vertices[i] * width),
                  list.begin() + std::ptrdiff_t((vertices[i] + 1) * width));
  return result;
}

bool usable(const dvec3& p) {
  return std::abs(p.x) < kFarthest && std::abs(p.y) < kFarthest && std::abs(p.z) < kFarthest;  // false for NaN
}

bool finite(const vec2& v) { return std::isfinite(v.x) && std::isfinite(v.y); }

class MeshReader {
 public:
  MeshReader(const GltfFile& file, std::vector<std::string>& warnings) : file_(file), warnings_(warnings) {}

  Mesh read(int index, const MaterialChoice& choice) {
    const Json& json = file_.all("meshes").at(index);
    where_ = fmt::format("meshes[{}]", index);
    Mesh mesh;
    mesh.name = file_.text(json, "name");
    if (mesh.name.empty()) mesh.name = fmt::format("mesh_{}", index);
    const Json& list = file_.list(json, "primitives", where_);
    for (const Json& primitive : list)
      if (file_.list(primitive, "targets", where_).size() != file_.list(list[0], "targets", where_).size())
        file_.refuse(where_, "its primitives have different numbers of morph targets");
    std::vector<Primitive> primitives;
    for (size_t i = 0; i < list.size(); ++i) {
      where_ = fmt::format("meshes[{}].primitives[{}]", index, i);
      std::optional<Primitive> primitive = readPrimitive(list[i], choice);
      if (primitive && !primitive->indices.empty()) primitives.push_back(*std::move(primitive));
    }
    recentre(primitives, mesh);
    return mesh;
  }

 private:
  void warn(const std::string& text) { warnings_.push_back(where_ + ": " + text); }

  void warnOfUnsound(size_t vertices, const char* what) {
    if (vertices > 0) warn(fmt::format("{} vertices have {}", vertices, what));
  }

  std::optional<Primitive> readPrimitive(const Json& json, const MaterialChoice& choice) {
    size_t mode = file_.size(json, "mode", 4, where_);
    if (mode < 4) {
      warn(mode == 0 ? "points are not drawn" : "lines are not drawn");
      return std::nullopt;
    }
    const Json& attributes = file_.object(json, "attributes", where_);
    Primitive primitive;
    primitive.material = materialOf(json, choice);
    if (!readPositions(attributes, primitive)) return std::nullopt;
    readAttributes(attributes, primitive);
    readTangents(attributes, primitive);
    readInfluences(attributes, primitive);
    readTargets(json, primitive);
    readIndices(json, int(mode), primitive);
    dropBadTriangles(primitive);
    if (!primitive.has_normals) facet(primitive);
    return primitive;
  }

  // Material of the chosen variant, else of the primitive, else the default.
  int materialOf(const Json& json, const MaterialChoice& choice) {
    int own = file_.index(json, "material", "materials", where_);
    for (const Json& mapping : file_.list(file_.extension(json, "KHR_materials_variants"), "mappings", where_)) {
      int material = file_.index(mapping, "material", "materials", where_);
      const Json& variants = file_.list(mapping, "variants", where_);
      if (choice.variant >= 0 && std::find(variants.begin(), variants.end(), Json(choice.variant)) != variants.end())
        return material;
    }
    return own < 0 ? choice.otherwise : own;
  }

  bool readPositions(const Json& attributes, Primitive& primitive) {
    int index = file_.index(attributes, "POSITION", "accessors", where_);
    if (index < 0) {
      warn("has no positions and is not drawn");
      return false;
    }
    Values values = file_.accessor(index, where_, {"VEC3"});
    primitive.vertices.resize(values.count);
    for (size_t i = 0; i < values.count; ++i) primitive.positions.push_back(values.vector3(i));
    return true;
  }

  std::optional<Values> attribute(const Json& attributes, const std::string& name, size_t count,
                                  const std::vector<std::string>& types) {
    int index = file_.index(attributes, name, "accessors", where_);
    if (index < 0) return std::nullopt;
    Values values = file_.accessor(index, where_, types);
    STROBE_ASSERT(values.count == count, "{}: {} has {} elements, not {}", where_, name, values.count, count);
    return values;
  }

  void readAttributes(const Json& attributes, Primitive& primitive) {
    std::vector<Vertex>& vertices = primitive.vertices;
    size_t count = vertices.size();
    if (auto normals = attribute(attributes, "NORMAL", count, {"VEC3"})) {
      primitive.has_normals = true;
      size_t unsound = 0;
      for (size_t i = 0; i < count; ++i) {
        dvec3 normal = normals->vector3(i);
        double length = glm::length(normal);
        unsound += !std::isfinite(length);
        vertices[i].normal = length > 1e-12 && std::isfinite(length) ? vec3(normal / length) : vec3(0);
      }
      warnOfUnsound(unsound, "normals that are not finite; facet normals are used instead");
    }
    for (int set = 0; set < 2; ++set) {
      auto uvs = attribute(attributes, fmt::format("TEXCOORD_{}", set), count, {"VEC2"});
      size_t unsound = 0;
      for (size_t i = 0; uvs && i < count; ++i) {
        vec2 uv(uvs->vector2(i));
        unsound += !finite(uv);
        (set == 0 ? vertices[i].uv0 : vertices[i].uv1) = finite(uv) ? uv : vec2(0);
      }
      warnOfUnsound(unsound, "texture coordinates that are not finite; 0, 0 is used instead");
    }
    auto colors = attribute(attributes, "COLOR_0", count, {"VEC3", "VEC4"});
    size_t unsound = 0;
    for (size_t i = 0; colors && i < count; ++i) {
      vec4 color(colors->vector3(i), colors->width == 4 ? colors->at(i, 3) : 1.0);
      bool sound = color.x >= 0 && color.y >= 0 && color.z >= 0 && color.w >= 0 && color.x + color.y + color.z < 1e9f;
      unsound += !sound;
      vertices[i].color = sound ? color : vec4(1);
    }
    warnOfUnsound(unsound, "colours that are negative or not finite; white is used instead");
  }

  // Tangents without normals are ignored, as the standard requires.
  void readTangents(const Json& attributes, Primitive& primitive) {
    auto tangents = attribute(attributes, "TANGENT", primitive.vertices.size(), {"VEC4"});
    size_t unsound = 0;
    for (size_t i = 0; tangents && i < tangents->count; ++i) {
      const dvec3 direction = tangents->vector3(i);
      const double sign = tangents->at(i, 3), length = glm::length(direction);
      const bool sound = length > 1e-12 && std::isfinite(length);
      unsound += !sound;
      primitive.tangents.push_back(sound ? vec4(direction / length, sign) : vec4(0));
    }
    warnOfUnsound(unsound,
                  "tangents that are 0 or not finite; tangents are derived from the texture coordinates instead");
    if (!primitive.has_normals) primitive.tangents.clear();
  }

  // Reads JOINTS_0 and WEIGHTS_0, JOINTS_1 and WEIGHTS_1, and so on.
  void readInfluences(const Json& attributes, Primitive& primitive) {
    const size_t count = primitive.vertices.size();
    std::vector<Values> joints, shares;
    while (auto set = attribute(attributes, fmt::format("JOINTS_{}", joints.size()), count, {"VEC4"})) {
      shares.push_back(*attribute(attributes, fmt::format("WEIGHTS_{}", joints.size()), count, {"VEC4"}));
      joints.push_back(*std::move(set));
    }
    primitive.influences.count = int(4 * joints.size());
    for (size_t v = 0; v < count && !joints.empty(); ++v) addInfluences(joints, shares, v, primitive);
  }

  void addInfluences(const std::vector<Values>& joints, const std::vector<Values>& shares, size_t vertex,
                     Primitive& primitive) {
    double sum = 0;
    for (const Values& set : shares)
      for (int c = 0; c < 4; ++c) {
        const double share = set.at(vertex, c);
        if (!(share >= 0 && share < 1e9))
          file_.refuse(where_, fmt::format("vertex {} has a weight of {}, which is not in the range from 0 to 1e9",
                                           vertex, share));
        sum += share;
      }
    if (sum == 0) file_.refuse(where_, fmt::format("all weights of vertex {} are 0", vertex));
    for (size_t s = 0; s < joints.size(); ++s)
      for (int c = 0; c < 4; ++c) {
        primitive.influences.joints.push_back(uint32_t(joints[s].at(vertex, c)));
        primitive.influences.shares.push_back(shares[s].at(vertex, c) / sum);
      }
  }

  void readTargets(const Json& json, Primitive& primitive) {
    const std::string own = where_;
    const Json& targets = file_.list(json, "targets", where_);
    for (size_t t = 0; t < targets.size(); ++t) {
      where_ = fmt::format("{}.targets[{}]", own, t);
      MorphTarget target;
      target.positions = changesOf(targets[t], "POSITION", primitive);
      target.normals = changesOf(targets[t], "NORMAL", primitive);
      target.tangents = changesOf(targets[t], "TANGENT", primitive);
      primitive.targets.push_back(std::move(target));
    }
    where_ = own;
  }

  std::vector<vec3> changesOf(const Json& target, const char* name, const Primitive& primitive) {
    std::vector<vec3> changes;
    auto values = attribute(target, name, primitive.vertices.size(), {"VEC3"});
    for (size_t i = 0; values && i < values->count; ++i) {
      if (!usable(values->vector3(i))) file_.refuse(where_, fmt::format("{} {} is not finite", name, i));
      changes.push_back(vec3(values->vector3(i)));
    }
    return changes;
  }

  void readIndices(const Json& json, int mode, Primitive& primitive) {
    int index = file_.index(json, "indices", "accessors", where_);
    std::vector<uint32_t> listed;
    if (index >= 0) listed = file_.indices(index, where_);
    for (size_t i = 0; index < 0 && i < primitive.positions.size(); ++i) listed.push_back(uint32_t(i));
    for (uint32_t i : listed)
      if (i >= primitive.positions.size())
        file_.refuse(where_, fmt::format("has index {}, but only {} vertices", i, primitive.positions.size()));
    if (mode == 4 && listed.size() % 3 != 0)
      warn(fmt::format("the number of indices is {}, not a multiple of 3", listed.size()));
    std::vector<uint32_t>& indices = primitive.indices;
    for (size_t i = 0; i + 2 < listed.size(); i += mode == 4 ? 3 : 1) {
      uint32_t a = listed[i], b = listed[i + 1], c = listed[i + 2];
      if (mode == 5 && i % 2 == 1) std::swap(a, b);  // every second triangle of a strip has the opposite winding
      if (mode == 6) a = listed[0];
      indices.insert(indices.end(), {a, b, c});
    }
  }

  void dropBadTriangles(Primitive& primitive) {
    std::vector<uint32_t> kept;
    const std::vector<uint32_t>& all = primitive.indices;
    for (size_t i = 0; i + 2 < all.size(); i += 3) {
      bool good = usable(primitive.positions[all[i]]) && usable(primitive.positions[all[i + 1]]) &&
                  usable(primitive.positions[all[i + 2]]);
      if (good) kept.insert(kept.end(), {all[i], all[i + 1], all[i + 2]});
    }
    if (kept.size() != all.size())
      warn(fmt::format("{} triangles have positions that are not finite and are left out",
                       (all.size() - kept.size()) / 3));
    for (dvec3& p : primitive.positions)
      if (!usable(p)) p = dvec3(0);
    primitive.indices = std::move(kept);
    repairNormals(primitive);
  }

  // Replaces normals of length 0 by the normal of an adjacent facet.
  void repairNormals(Primitive& primitive) {
    if (!primitive.has_normals) return;
    for (size_t i = 0; i < primitive.indices.size(); ++i) {
      Vertex& vertex = primitive.vertices[primitive.indices[i]];
      if (vertex.normal == vec3(0)) vertex.normal = facetNormal(primitive, i / 3);
    }
    for (Vertex& vertex : primitive.vertices)
      if (vertex.normal == vec3(0)) vertex.normal = vec3(0, 1, 0);
  }

  static vec3 facetNormal(const Primitive& primitive, size_t triangle) {
    dvec3 a = primitive.positions[primitive.indices[3 * triangle]];
    dvec3 b = primitive.positions[primitive.indices[3 * triangle + 1]];
    dvec3 c = primitive.positions[primitive.indices[3 * triangle + 2]];
    dvec3 normal = glm::cross(b - a, c - a);
    double length = glm::length(normal);
    return length > 0 && std::isfinite(length) ? vec3(normal / length) : vec3(0, 1, 0);
  }

  // Makes one vertex per corner, with the normal of its facet.
  static void facet(Primitive& primitive) {
    Primitive flat;
    flat.material = primitive.material;
    for (size_t i = 0; i < primitive.indices.size(); ++i) {
      uint32_t corner = primitive.indices[i];
      flat.positions.push_back(primitive.positions[corner]);
      flat.vertices.push_back(primitive.vertices[corner]);
      flat.vertices.back().normal = facetNormal(primitive, i / 3);
      flat.indices.push_back(uint32_t(i));
    }
    const std::vector<uint32_t>& corners = primitive.indices;
    const Influences& influences = primitive.influences;
    flat.influences = {influences.count, picked(influences.joints, corners, size_t(influences.count)),
                       picked(influences.shares, corners, size_t(influences.count))};
    for (const MorphTarget& target : primitive.targets) flat.targets.push_back({picked(target.positions, corners, 1)});
    primitive = std::move(flat);
  }

  static void recentre(std::vector<Primitive>& primitives, Mesh& mesh) {
    Bounds bounds;
    for (const Primitive& primitive : primitives)
      for (uint32_t i : primitive.indices) bounds.add(primitive.positions[i]);
    mesh.origin = originFor(bounds);
    for (Primitive& primitive : primitives) {
      for (size_t i = 0; i < primitive.vertices.size(); ++i)
        primitive.vertices[i].position = vec3(primitive.positions[i] - mesh.origin);
      Geometry geometry{std::move(primitive.vertices), std::move(primitive.indices), primitive.material};
      geometry.influences = std::move(primitive.influences);
      geometry.tangents = std::move(primitive.tangents);
      geometry.targets = std::move(primitive.targets);
      geometry.faceted = !primitive.has_normals;
      mesh.geometries.push_back(std::move(geometry));
    }
  }

  const GltfFile& file_;
  std::vector<std::string>& warnings_;
  std::string where_;
};

}  // namespace

Mesh readMesh(const GltfFile& file, int index, const MaterialChoice& choice, std::vector<std::string>& warnings) {
  return MeshReader(file, warnings).read(index, choice);
}

// Counts the unused attributes of a primitive or of a morph target, by name.
static void addUnused(const Json& attributes, bool is_target, std::map<std::string, size_t>& counts) {
  for (const auto& [name, value] : attributes.items()) {
    const bool is_set = name.starts_with("TEXCOORD_") || name.starts_with("COLOR_");
    const bool is_used = !is_target && (name == "TEXCOORD_0" || name == "TEXCOORD_1" || name == "COLOR_0");
    if (is_set && !is_used) ++counts[is_target ? name + " of morph targets" : name];
  }
}

void warnOfUnusedAttributes(const GltfFile& file, std::vector<std::string>& warnings) {
  std::map<std::string, size_t> counts;
  for (const Json& mesh : file.all("meshes"))
    for (const Json& primitive : file.list(mesh, "primitives", "meshes")) {
      std::map<std::string, size_t> own;
      addUnused(file.object(primitive, "attributes", "meshes"), false, own);
      for (const Json& target : file.list(primitive, "targets", "meshes")) addUnused(target, true, own);
      for (const auto& [name, count] : own) ++counts[name];
    }
  std::vector<std::string> names;
  for (const auto& [name, count] : counts)
    names.push_back(fmt::format("{} ({} {})", name, count, count == 1 ? "primitive" : "primitives"));
  if (!names.empty()) warnings.push_back(fmt::format("attributes are not used: {}", fmt::join(names, ", ")));
}

void dropIdleTangents(Scene& scene) {
  for (Mesh& mesh : scene.meshes)
    for (Geometry& geometry : mesh.geometries) {
      if (scene.materials[size_t(geometry.material)].normal_texture.texture >= 0) continue;
      geometry.tangents = {};
      for (MorphTarget& target : geometry.targets) target.tangents = {};
    }
}

}  // namespace strobe::scene
