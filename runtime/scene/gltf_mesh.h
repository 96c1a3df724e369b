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

// Adds one warning that names the attributes of meshes and of morph targets that have no use here. The meshes are
// sound.
void warnOfUnusedAttributes(const GltfFile& file, std::vector<std::string>& warnings);

// Drops the tangents of geometries without a normal map.
void dropIdleTangents(Scene& scene);

}  // namespace strobe::scene
