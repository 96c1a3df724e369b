// SPDX-License-Identifier: MIT
// Names of the ids in a picture.
#pragma once

#include <string>
#include <vector>

#include "base/json_fwd.h"
#include "scene/scene.h"

namespace strobe::lab {

// Drawables of one node: one, or several with `EXT_mesh_gpu_instancing`. An id in an image is the index of the drawable
// + 1; 0 is the sky. A geometry id is the index of the geometry in its mesh + 1.
struct IdName {
  uint32_t first = 1, last = 1;        // ids of the drawables, inclusive
  std::string node;                    // name of the node, "node 7" without a name
  std::vector<std::string> materials;  // material name of each geometry, "material 7" without a name
};

// Names in the order of ids, without gaps.
std::vector<IdName> idNamesOf(const scene::Scene& scene);

// [{"first": 1, "last": 1, "node": "vase", "materials": ["clay"]}, ...]
Json toJson(const std::vector<IdName>& names);

// Node of an image id, and material of a geometry id in its instance. Unknown ids: "instance 7", "geometry 7".
std::string nodeOf(const std::vector<IdName>& names, uint32_t id);
std::string materialOf(const std::vector<IdName>& names, uint32_t id, uint32_t geometry);

}  // namespace strobe::lab
