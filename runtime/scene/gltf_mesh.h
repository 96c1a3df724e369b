// SPDX-License-Identifier: MIT
// glTF meshes as triangles.
#pragma once

#include "scene/gltf_file.h"

namespace strobe::scene {

// Selection of the materials of glTF primitives: the material variant, and the default material.
struct MaterialChoice {
  int otherwise = 0;  // for primitives without a material
  int variant = -1;   // index in KHR_materials_variants; -1: no variant
};

// Reads the mesh `index` of the file. Strips and fans become triangles. Missing normals become facet normals. Triangles
// with vertices that are not finite are dropped. Parts that are left out are added to `warnings`.
Mesh readMesh(const GltfFile& file, int index, const MaterialChoice& choice, std::vector<std::string>& warnings);

// Adds one warning that lists the unused attributes of meshes and of morph targets. The meshes must be valid.
void warnOfUnusedAttributes(const GltfFile& file, std::vector<std::string>& warnings);

// Drops the tangents of geometries without a normal map.
void dropIdleTangents(Scene& scene);

}  // namespace strobe::scene
