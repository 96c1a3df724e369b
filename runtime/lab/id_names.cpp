// SPDX-License-Identifier: MIT
#include "lab/id_names.h"

#include <fmt/format.h>

#include <algorithm>

namespace strobe::lab {

static std::string named(const std::string& name, const char* kind, int index) {
  return name.empty() ? fmt::format("{} {}", kind, index) : name;
}

static std::vector<std::string> materialsOf(const scene::Scene& scene, int mesh) {
  std::vector<std::string> names;
  for (const scene::Geometry& geometry : scene.meshes[size_t(mesh)].geometries)
    names.push_back(named(scene.materials[size_t(geometry.material)].name, "material", geometry.material));
  return names;
}

std::vector<IdName> idNamesOf(const scene::Scene& scene) {
  std::vector<IdName> names;
  int last_node = -1;
  uint32_t id = 0;
  for (const scene::Instance& instance : scene::instancesOf(scene)) {
    ++id;
    if (instance.node == last_node) {
      names.back().last = id;
      continue;
    }
    last_node = instance.node;
    const std::string& name = scene.nodes[size_t(instance.node)].name;
    names.push_back({id, id, named(name, "node", instance.node), materialsOf(scene, instance.mesh)});
  }
  return names;
}

Json toJson(const std::vector<IdName>& names) {
  Json json = Json::array();
  for (const IdName& name : names)
    json.push_back({{"first", name.first}, {"last", name.last}, {"node", name.node}, {"materials", name.materials}});
  return json;
}

static const IdName* find(const std::vector<IdName>& names, uint32_t id) {
  auto found = std::lower_bound(names.begin(), names.end(), id,
                                [](const IdName& name, uint32_t wanted) { return name.last < wanted; });
  return found != names.end() && found->first <= id ? &*found : nullptr;
}

std::string nodeOf(const std::vector<IdName>& names, uint32_t id) {
  const IdName* name = find(names, id);
  return name ? name->node : fmt::format("instance {}", id);
}

std::string materialOf(const std::vector<IdName>& names, uint32_t id, uint32_t geometry) {
  const IdName* name = find(names, id);
  bool known = name && geometry >= 1 && geometry <= name->materials.size();
  return known ? name->materials[geometry - 1] : fmt::format("geometry {}", geometry);
}

}  // namespace strobe::lab
