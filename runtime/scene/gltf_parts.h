// SPDX-License-Identifier: MIT
// Readers and checks of the parts of a glTF file. Each section has its own source file (gltf_mesh.cpp, ...).
#pragma once

#include "scene/gltf_file.h"

namespace strobe::scene {

// ---- meshes

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

// ---- materials

// Adds the materials of the file and their textures to the scene. The last material is the default of primitives
// without a material. Parts that are left out are added to the warnings. Throws `Error` before images are decoded if
// all images together need more than `most_bytes`.
void readMaterials(GltfFile& file, Scene& scene, uint64_t most_bytes);

// ---- skins and weights

// Adds the skins of the file to a scene with its meshes and nodes, and sets the skin and the weights of nodes. Throws
// `Error` if a mesh with a skin has no joints, or follows a joint that its skin lacks.
void readSkins(const GltfFile& file, Scene& scene);

// Sets the `sole_joint` of all nodes. The animations must be read already.
void findSoleJoints(Scene& scene);

// Number of morph targets of a mesh of the file.
size_t targetsOf(const GltfFile& file, int mesh);

// Removes weights without an effect: 0 at rest, and not driven.
void dropIdleWeights(Scene& scene);

// ---- animations

// Adds the animations of the file to a scene with its nodes. Animated nodes get translation, rotation and scale in
// place of a matrix. Parts that are left out are added to the warnings.
void readAnimations(const GltfFile& file, Scene& scene);

// ---- form

// Names of the supported extensions.
const std::vector<std::string>& supportedExtensions();

// True if the file declares the extension as used or required.
bool declares(const GltfFile& file, const std::string& extension);

// Compares every object of the file, used or not, with its form in the standard: required members, their types, ranges
// and references. Throws `Error` with the place of the first difference. Also refuses an extension that is used but not
// declared, or that is in a place without a meaning. Members without a form are ignored.
void requireForm(const GltfFile& file);

// ---- uses

// Throws `Error` with the place for these errors: an accessor of an attribute, of indices or of keys has another format
// or count; an attribute has no meaning; a node of a scene is not a root; a camera or an image states two contents.
// Adds a warning for each texture with coordinates that its primitive lacks.
void requireUses(const GltfFile& file, std::vector<std::string>& warnings);

// ---- memory

// Throws `Error` with the numbers and the largest need if the meshes, morph targets, instances, keys and compressed
// parts of the file together need more than 1 GiB plus 1000 times the bytes of the file, or more than is available. A
// count in an accessor is a few bytes of JSON, so a short file may state any amount. Called before memory is allocated
// by such a count.
void requireMemory(const GltfFile& file);

}  // namespace strobe::scene
