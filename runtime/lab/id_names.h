// SPDX-License-Identifier: MIT
// What the ids in a picture stand for.
#pragma once

#include <string>
#include <vector>

#include "base/json_fwd.h"
#include "scene/scene.h"

namespace strobe::lab {

// The drawables of one node: one, or as many as `EXT_mesh_gpu_instancing` makes. In images an id is the index of the
// drawable + 1, and that of a geometry its index in the mesh + 1; 0 is the sky.
struct IdName {
  uint32_t first = 1, last = 1;        // ids of the drawables, inclusive
  std::string node;                    // its name, "node 7" where it has none
  std::vector<std::string> materials;  // of each geometry; "material 7" where it has no name
};

// In the order of ids, without gaps.
std::vector<IdName> idNamesOf(const scene::Scene& scene);

// [{"first": 1, "last": 1, "node": "vase", "materials": ["clay"]}, ...]
Json toJson(const std::vector<IdName>& names);

// Names of ids as they stand in images, a geometry's in its instance; "instance 7", "geometry 7" where there is none.
std::string nodeOf(const std::vector<IdName>& names, uint32_t id);
std::string materialOf(const std::vector<IdName>& names, uint32_t id, uint32_t geometry);

}  // namespace strobe::lab
