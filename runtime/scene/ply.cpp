// SPDX-License-Identifier: MIT
#include "scene/ply.h"

#include <fmt/format.h>

#include <bit>

namespace strobe::scene {

static_assert(std::endian::native == std::endian::little, "files are written as memory holds them");

template <class Value>
static void appendTo(std::string& bytes, const Value& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

static std::string headerOf(const Geometry& geometry) {
  std::string header = "ply\nformat binary_little_endian 1.0\n";
  header += fmt::format("element vertex {}\n", geometry.vertices.size());
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz", "u", "v"})
    header += fmt::format("property float {}\n", name);
  header += fmt::format("element face {}\n", geometry.indices.size() / 3);
  return header + "property list uchar int vertex_indices\nend_header\n";
}

std::string plyOf(const Geometry& geometry, const TextureUse& texture, const BentVertex* deformed) {
  std::string bytes = headerOf(geometry);
  for (size_t i = 0; i < geometry.vertices.size(); ++i) {
    const Vertex& vertex = geometry.vertices[i];
    appendTo(bytes, deformed ? vec3(deformed[i].position) : vertex.position);
    appendTo(bytes, deformed ? vec3(deformed[i].normal) : vertex.normal);
    appendTo(bytes, vec2(texture.uv_transform * dvec3(texture.uv_set == 0 ? vertex.uv0 : vertex.uv1, 1)));
  }
  for (size_t i = 0; i < geometry.indices.size(); ++i) {
    if (i % 3 == 0) appendTo(bytes, uint8_t(3));
    appendTo(bytes, int32_t(geometry.indices[i]));
  }
  return bytes;
}

}  // namespace strobe::scene
