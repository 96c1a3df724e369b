// SPDX-License-Identifier: MIT
// Decoders of EXT_meshopt_compression and KHR_draco_mesh_compression. Streams are not trusted: before decoding, the
// sizes in their headers are compared with the sizes that the file states.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace strobe::scene {

// Compressed bytes of a buffer view, and their format.
struct MeshoptStream {
  std::span<const uint8_t> bytes;
  size_t count = 0, stride = 0;  // number of elements, and bytes per element
  std::string mode, filter;      // as named by the extension; an empty filter is "NONE"
};

// Returns `count` elements of `stride` bytes. Throws `std::runtime_error` with the reason for a damaged stream, or if
// the mode or the filter does not allow the stride.
std::vector<uint8_t> decodeMeshopt(const MeshoptStream& stream);

// Attribute of a Draco stream that an accessor refers to.
struct DracoNumbers {
  uint32_t id = 0;         // of the attribute in the stream
  int component_type = 0;  // component type of glTF
  int width = 0;           // number of components
};

// Draco-compressed triangle mesh: its bytes, the stated numbers of vertices and indices, and the attributes to decode.
struct DracoStream {
  std::span<const uint8_t> bytes;
  size_t vertices = 0, indices = 0;           // as stated by the accessors
  int index_type = 0;                         // component type of the indices
  std::map<std::string, DracoNumbers> asked;  // requested attributes, by name
};

// Decoded indices and vertex attributes of a Draco-compressed mesh, as raw bytes in the formats of their glTF
// accessors.
struct DracoMesh {
  std::vector<uint8_t> indices;
  std::map<std::string, std::vector<uint8_t>> attributes;  // tightly packed
};

// Throws `std::runtime_error` with the reason for a stream that is damaged or lacks an attribute.
DracoMesh decodeDraco(const DracoStream& stream);

}  // namespace strobe::scene
