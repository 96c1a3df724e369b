// SPDX-License-Identifier: MIT
// glTF meshes to triangles.
#pragma once

#include "scene/gltf_file.h"

namespace strobe::scene {

// The mesh `index` of the file. Strips and fans become triangles, missing normals become those of the facets, vertices
// that are not finite lose their triangles. What is left out is added to `warnings`. `default_material` serves
// primitives that name none.
Mesh readMesh(const GltfFile& file, int index, int default_material, std::vector<std::string>& warnings);

}  // namespace strobe::scene
