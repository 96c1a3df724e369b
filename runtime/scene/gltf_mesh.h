// SPDX-License-Identifier: MIT
// glTF meshes to triangles.
#pragma once

#include "scene/gltf_file.h"

namespace strobe::scene {

struct MaterialChoice {
  int otherwise = 0;  // of primitives that name none
  int variant = -1;   // of KHR_materials_variants
};

// The mesh `index` of the file. Strips and fans become triangles, missing normals become those of the facets, vertices
// that are not finite lose their triangles. What is left out is added to `warnings`.
Mesh readMesh(const GltfFile& file, int index, const MaterialChoice& choice, std::vector<std::string>& warnings);

}  // namespace strobe::scene
