// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "base/memory.h"
#include "scene/gltf_parts.h"

namespace strobe::scene {

namespace {

constexpr double kGibibyte = double(1 << 30);

// Limit of memory per byte of the file. Indices of one byte, if their corners get facet normals, need about 100, and
// compression saves a factor of about 10.
constexpr double kMostPerByte = 1000;

// Memory of an instance: its matrices in the file's scene, in a pose and on the device.
constexpr double kInstanceBytes = 512;

std::string gibibytes(double bytes) { return fmt::format("{:.1f} GiB", bytes / kGibibyte); }

// Memory sums in double precision, so that products of counts from the file stay in range.
class Needs {
 public:
  explicit Needs(const GltfFile& file) : file_(file) {}

  void require() {
    addMeshes();
    addNodes();
    addSkins();
    addAnimations();
    addViews();
    refuseAbove(kGibibyte + kMostPerByte * double(file_.bytesRead()), "allowed for a file of its size");
    refuseAbove(double(availableMemory()), "of available memory");
  }

 private:
  void refuseAbove(double limit, const char* what) const {
    if (sum_ <= limit) return;
    file_.refuse(largest_where_, fmt::format("needs {} of memory; the whole file needs {}, more than the {} {}",
                                             gibibytes(largest_), gibibytes(sum_), gibibytes(limit), what));
  }

  void add(const std::string& where, double bytes) {
    sum_ += bytes;
    if (bytes > largest_) largest_ = bytes, largest_where_ = where;
  }

  double countOf(int accessor) const { return accessor < 0 ? 0 : double(file_.format(accessor).count); }
  double countOf(const Json& object, const char* key) const {
    return countOf(file_.index(object, key, "accessors", ""));
  }

  void addMeshes() {
    const Json& meshes = file_.all("meshes");
    for (size_t m = 0; m < meshes.size(); ++m) {
      const Json& primitives = file_.list(meshes[m], "primitives", "");
      for (size_t p = 0; p < primitives.size(); ++p)
        addPrimitive(primitives[p], fmt::format("meshes[{}].primitives[{}]", m, p));
    }
  }

  void addPrimitive(const Json& json, const std::string& where) {
    const Json& attributes = json["attributes"];
    double vertices = 0, influences = 0;
    for (const auto& [name, accessor] : attributes.items()) {
      vertices = std::max(vertices, countOf(attributes, name.c_str()));
      influences += name.starts_with("JOINTS_") ? 4 : 0;
    }
    double vertex = sizeof(dvec3) + sizeof(Vertex) + influences * (sizeof(uint32_t) + sizeof(double));
    for (const Json& target : file_.list(json, "targets", "")) vertex += double(target.size()) * sizeof(vec3);
    const bool indexed = json.contains("indices"), strip = file_.size(json, "mode", 4, "") > 4;
    const double corners = (indexed ? countOf(json, "indices") : vertices) * (strip ? 3 : 1);
    const double read = (4 + 2 * influences) * sizeof(double);  // accessor values during reading
    double bytes = vertices * (vertex + read) + corners * (sizeof(double) + 3 * sizeof(uint32_t));
    if (!attributes.contains("NORMAL")) bytes += corners * vertex;  // one vertex per corner
    if (!file_.extension(json, "KHR_draco_mesh_compression").empty()) bytes += vertices * vertex + corners * 8;
    add(where, bytes);
  }

  void addNodes() {
    const Json& nodes = file_.all("nodes");
    for (size_t i = 0; i < nodes.size(); ++i) {
      const Json& instancing = file_.extension(nodes[i], "EXT_mesh_gpu_instancing");
      double instances = 0;
      for (const auto& [name, accessor] : file_.object(instancing, "attributes", "").items())
        instances = std::max(instances, countOf(instancing["attributes"], name.c_str()));
      add(fmt::format("nodes[{}]", i), instances * kInstanceBytes);
    }
  }

  void addSkins() {
    const Json& skins = file_.all("skins");
    for (size_t i = 0; i < skins.size(); ++i)
      add(fmt::format("skins[{}]", i), countOf(skins[i], "inverseBindMatrices") * 2 * sizeof(dmat4));
  }

  void addAnimations() {
    const Json& animations = file_.all("animations");
    for (size_t i = 0; i < animations.size(); ++i) {
      const Json& channels = animations[i]["channels"];
      for (size_t k = 0; k < channels.size(); ++k)
        addChannel(animations[i]["samplers"], channels[k], fmt::format("animations[{}].channels[{}]", i, k));
    }
  }

  // Each target and node has its own keys of weights.
  void addChannel(const Json& samplers, const Json& channel, const std::string& where) {
    const size_t sampler = file_.size(channel, "sampler", std::nullopt, where);
    if (sampler >= samplers.size()) return;
    const double times = countOf(samplers[sampler], "input"), values = countOf(samplers[sampler], "output");
    const std::string path = file_.text(channel["target"], "path", where);
    const bool weights = path == "weights" || path == "pointer";
    const double nodes = path == "pointer" ? double(file_.all("nodes").size()) : 1;
    const double tracks = weights ? std::max(1.0, values / std::max(1.0, times)) * nodes : 1;
    add(where, (times * tracks + 4 * values) * sizeof(double) + values * sizeof(dvec4) * nodes);
  }

  void addViews() {
    const Json& views = file_.all("bufferViews");
    for (size_t i = 0; i < views.size(); ++i) {
      const Json& meshopt = file_.extension(views[i], "EXT_meshopt_compression");
      if (meshopt.empty()) continue;
      const std::string where = fmt::format("bufferViews[{}]", i);
      add(where, double(file_.size(meshopt, "count", 0, where)) * double(file_.size(meshopt, "byteStride", 0, where)));
    }
  }

  const GltfFile& file_;
  double sum_ = 0, largest_ = 0;
  std::string largest_where_;
};

}  // namespace

void requireMemory(const GltfFile& file) { Needs(file).require(); }

}  // namespace strobe::scene
