// SPDX-License-Identifier: MIT
// Decoders of EXT_meshopt_compression and KHR_draco_mesh_compression. Streams are not trusted: sizes in their headers
// are compared with the sizes that the file states before anything is decoded.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace strobe::scene {

// Bytes of a buffer view.
struct MeshoptStream {
  std::span<const uint8_t> bytes;
  size_t count = 0, stride = 0;  // elements, and bytes of each
  std::string mode, filter;      // as the extension names them; an empty filter is "NONE"
};

// `count` elements of `stride` bytes. Throws `std::runtime_error` with the reason for a stream that is damaged, or of a
// mode or filter that does not go with its stride.
std::vector<uint8_t> decodeMeshopt(const MeshoptStream& stream);

// Numbers that a Draco stream holds for an accessor.
struct DracoNumbers {
  uint32_t id = 0;         // of the attribute in the stream
  int component_type = 0;  // as glTF numbers them
  int width = 0;           // components
};

struct DracoStream {
  std::span<const uint8_t> bytes;
  size_t vertices = 0, indices = 0;           // as the accessors state them
  int index_type = 0;                         // component type of the indices
  std::map<std::string, DracoNumbers> asked;  // by the names of attributes
};

struct DracoMesh {
  std::vector<uint8_t> indices;
  std::map<std::string, std::vector<uint8_t>> attributes;  // tightly packed
};

// Throws `std::runtime_error` with the reason for a stream that is damaged or lacks an attribute.
DracoMesh decodeDraco(const DracoStream& stream);

}  // namespace strobe::scene
