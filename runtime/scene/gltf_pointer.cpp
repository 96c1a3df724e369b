// SPDX-License-Identifier: MIT
#include "scene/gltf_pointer.h"

#include <charconv>

#include "scene/gltf_parts.h"

namespace strobe::scene {

namespace {

using Target = Track::Target;

const Json& listAt(const GltfFile& file, const std::string& pointer) {
  if (pointer == "/nodes/") return file.all("nodes");
  if (pointer == "/cameras/") return file.all("cameras");
  return file.list(file.extension(file.json(), "KHR_lights_punctual"), "lights", "");
}

struct Row {
  const char* list;   // pointer before the number
  const char* rest;   // pointer after the number
  const char* needs;  // a member that the object must have; "" for none
  Target target;
  int components = 1;
};

constexpr const char* kLights = "/extensions/KHR_lights_punctual/lights/";

const Row kRows[] = {
    {"/nodes/", "/translation", "", Target::Translation, 3},
    {"/nodes/", "/rotation", "", Target::Rotation, 4},
    {"/nodes/", "/scale", "", Target::Scale, 3},
    {"/cameras/", "/perspective/yfov", "perspective", Target::FieldOfView},
    {"/cameras/", "/perspective/znear", "perspective", Target::Near},
    {"/cameras/", "/orthographic/ymag", "orthographic", Target::HalfHeight},
    {"/cameras/", "/orthographic/znear", "orthographic", Target::Near},
    {kLights, "/color", "", Target::Color, 3},
    {kLights, "/intensity", "", Target::Intensity},
    {kLights, "/range", "", Target::Range},
    {kLights, "/spot/innerConeAngle", "spot", Target::InnerCone},
    {kLights, "/spot/outerConeAngle", "spot", Target::OuterCone},
};

// Number between two parts of a pointer; nothing if the pointer has other parts.
std::optional<size_t> numberIn(const std::string& pointer, const std::string& list, const std::string& rest) {
  if (!pointer.starts_with(list) || !pointer.ends_with(rest) || pointer.size() <= list.size() + rest.size()) return {};
  size_t number = 0;
  const char *from = pointer.data() + list.size(), *to = pointer.data() + pointer.size() - rest.size();
  auto [end, failure] = std::from_chars(from, to, number);
  return failure == std::errc() && end == to ? std::optional(number) : std::nullopt;
}

// Nodes that have the weights of a mesh, because they state no weights.
std::vector<int> nodesWithWeightsOf(const GltfFile& file, int mesh) {
  std::vector<int> found;
  const Json& nodes = file.all("nodes");
  for (size_t i = 0; i < nodes.size(); ++i)
    if (file.index(nodes[i], "mesh", "meshes", "") == mesh && !nodes[i].contains("weights")) found.push_back(int(i));
  return found;
}

// Target of /nodes/N/weights or /meshes/N/weights, optionally followed by the index of one weight.
std::optional<PointerTarget> weightsTarget(const GltfFile& file, const std::string& pointer, const std::string& where) {
  const size_t at = pointer.find("/weights");
  if (at == std::string::npos) return std::nullopt;
  const std::string list = pointer.starts_with("/meshes/") ? "meshes" : "nodes", rest = pointer.substr(at);
  const std::optional<size_t> number = numberIn(pointer, "/" + list + "/", rest);
  const std::optional<size_t> one = numberIn(rest, "/weights/", "");
  if (!number || (rest != "/weights" && !one)) return std::nullopt;
  auto refuse = [&] { file.refuse(where, fmt::format("the target of its pointer '{}' does not exist", pointer)); };
  if (*number >= file.all(list).size()) refuse();
  const bool of_mesh = list == "meshes";
  const int mesh = of_mesh ? int(*number) : file.index(file.all("nodes")[*number], "mesh", "meshes", where);
  const size_t count = mesh < 0 ? 0 : targetsOf(file, mesh);
  if (count == 0 || (one && *one >= count)) refuse();
  PointerTarget result{Target::Weight};
  result.morphed = of_mesh ? nodesWithWeightsOf(file, mesh) : std::vector<int>{int(*number)};
  result.first_weight = one.value_or(0);
  result.components = one ? 1 : int(count);
  return result;
}

}  // namespace

PointerTarget weightsOf(const GltfFile& file, const std::vector<int>& nodes, const std::string& where) {
  PointerTarget result{Target::Weight};
  result.morphed = nodes;
  for (int node : nodes) {
    const int mesh = file.index(file.all("nodes").at(node), "mesh", "meshes", where);
    result.components = mesh < 0 ? 0 : int(targetsOf(file, mesh));
    if (result.components == 0)
      file.refuse(where, fmt::format("drives weights of node {}, which has no weights", node));
  }
  return result;
}

std::optional<PointerTarget> pointerTarget(const GltfFile& file, const std::string& pointer, const std::string& where) {
  for (const Row& row : kRows) {
    std::optional<size_t> number = numberIn(pointer, row.list, row.rest);
    if (!number) continue;
    const Json& list = listAt(file, row.list);
    bool is_there = *number < list.size() && (!*row.needs || list[*number].contains(row.needs));
    if (!is_there) file.refuse(where, fmt::format("the target of its pointer '{}' does not exist", pointer));
    PointerTarget result;
    result.object = int(*number);
    result.target = row.target;
    result.components = row.components;
    return result;
  }
  return weightsTarget(file, pointer, where);
}

}  // namespace strobe::scene
