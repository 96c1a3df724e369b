// SPDX-License-Identifier: MIT
#include "scene/gltf_compression.h"

#include <fmt/format.h>
#include <meshoptimizer.h>

#include <cstring>
#include <limits>
#include <stdexcept>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/core/varint_decoding.h>
#pragma GCC diagnostic pop

namespace strobe::scene {

namespace {

[[noreturn]] void fail(const std::string& text) { throw std::runtime_error(text); }

// --- meshopt ------------------------------------------------------------------------------------------------------

void applyFilter(const MeshoptStream& stream, uint8_t* to) {
  const size_t stride = stream.stride;
  auto require = [&](bool fits) {
    if (!fits) fail(fmt::format("filter {} is not allowed with elements of {} bytes", stream.filter, stride));
  };
  if (stream.filter.empty() || stream.filter == "NONE") return;
  if (stream.mode != "ATTRIBUTES")
    fail(fmt::format("filter {} is not allowed with mode {}", stream.filter, stream.mode));
  if (stream.filter == "OCTAHEDRAL") {
    require(stride == 4 || stride == 8);
    meshopt_decodeFilterOct(to, stream.count, stride);
  } else if (stream.filter == "QUATERNION") {
    require(stride == 8);
    meshopt_decodeFilterQuat(to, stream.count, stride);
  } else {
    require(stride % 4 == 0);
    meshopt_decodeFilterExp(to, stream.count, stride);
  }
}

// --- Draco --------------------------------------------------------------------------------------------------------

// Decoder that compares the counts in the stream's headers with the accessors before it allocates.
template <class Decoder>
class CheckedDecoder : public Decoder {
 public:
  explicit CheckedDecoder(const DracoStream& stream) : stream_(stream) {}

 protected:
  bool DecodeConnectivity() override {
    draco::DecoderBuffer ahead = *this->buffer();
    uint32_t first = 0, second = 0;
    if (!draco::DecodeVarint(&first, &ahead) || !draco::DecodeVarint(&second, &ahead)) return false;
    constexpr bool kFacesFirst = std::is_same_v<Decoder, draco::MeshSequentialDecoder>;
    const size_t faces = kFacesFirst ? first : second, vertices = kFacesFirst ? second : first;
    if (faces * 3 != stream_.indices)
      fail(fmt::format("it has {} triangles, but its accessor has {} indices", faces, stream_.indices));
    if (vertices > stream_.vertices)
      fail(fmt::format("it has {} vertices, but its accessors have {}", vertices, stream_.vertices));
    return Decoder::DecodeConnectivity();
  }

  // Called when the attributes are listed, but not yet allocated.
  bool DecodeAllAttributes() override {
    const draco::PointCloud& points = *this->point_cloud();
    if (points.num_points() != stream_.vertices)
      fail(fmt::format("it has {} vertices, but its accessors have {}", points.num_points(), stream_.vertices));
    // Attributes without an accessor are decoded too.
    constexpr size_t kMostComponents = 256;
    size_t components = 0;
    for (int i = 0; i < points.num_attributes(); ++i) components += points.attribute(i)->num_components();
    if (components > kMostComponents)
      fail(fmt::format("it has {} numbers per vertex, above the limit of {}", components, kMostComponents));
    return Decoder::DecodeAllAttributes();
  }

 private:
  const DracoStream& stream_;
};

template <class Decoder>
void decodeMesh(const DracoStream& stream, draco::DecoderBuffer& buffer, draco::Mesh& mesh) {
  CheckedDecoder<Decoder> decoder(stream);
  const draco::Status status = decoder.Decode(draco::DecoderOptions(), &buffer, &mesh);
  const std::string& reason = status.error_msg_string();
  if (!status.ok()) fail("it is damaged" + (reason.empty() ? "" : ": " + reason));
}

template <class T>
void append(std::vector<uint8_t>& bytes, T value) {
  const uint8_t* from = reinterpret_cast<const uint8_t*>(&value);
  bytes.insert(bytes.end(), from, from + sizeof value);
}

template <class T>
std::vector<uint8_t> numbersOf(const draco::PointAttribute& attribute, const std::string& name, size_t points,
                               int width) {
  std::vector<uint8_t> bytes;
  bytes.reserve(points * size_t(width) * sizeof(T));
  T values[16] = {};
  for (uint32_t p = 0; p < points; ++p) {
    const draco::AttributeValueIndex index = attribute.mapped_index(draco::PointIndex(p));
    if (index.value() >= attribute.size() || !attribute.ConvertValue(index, int8_t(width), values))
      fail(fmt::format("{} of vertex {} cannot be converted to the type of its accessor", name, p));
    for (int c = 0; c < width; ++c) append(bytes, values[c]);
  }
  return bytes;
}

std::vector<uint8_t> attributeOf(const draco::Mesh& mesh, const std::string& name, const DracoNumbers& asked) {
  const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(asked.id);
  if (!attribute) fail(fmt::format("it has no attribute {} for {}", asked.id, name));
  if (attribute->num_components() != asked.width)
    fail(fmt::format("{} has {} components, but its accessor has {}", name, attribute->num_components(), asked.width));
  if (draco::IsDataTypeIntegral(attribute->data_type()) == (asked.component_type == 5126))
    fail(fmt::format("the type of {} differs from the type of its accessor", name));
  const size_t points = mesh.num_points();
  switch (asked.component_type) {
    case 5120:
      return numbersOf<int8_t>(*attribute, name, points, asked.width);
    case 5121:
      return numbersOf<uint8_t>(*attribute, name, points, asked.width);
    case 5122:
      return numbersOf<int16_t>(*attribute, name, points, asked.width);
    case 5123:
      return numbersOf<uint16_t>(*attribute, name, points, asked.width);
    case 5125:
      return numbersOf<uint32_t>(*attribute, name, points, asked.width);
    default:
      return numbersOf<float>(*attribute, name, points, asked.width);
  }
}

template <class T>
std::vector<uint8_t> indicesOf(const draco::Mesh& mesh) {
  if (mesh.num_points() > size_t(std::numeric_limits<T>::max()))
    fail(fmt::format("its {} vertices are above the range of the type of its indices", mesh.num_points()));
  std::vector<uint8_t> bytes;
  bytes.reserve(size_t(mesh.num_faces()) * 3 * sizeof(T));
  for (uint32_t f = 0; f < mesh.num_faces(); ++f)
    for (int c = 0; c < 3; ++c) append(bytes, T(mesh.face(draco::FaceIndex(f))[c].value()));
  return bytes;
}

}  // namespace

std::vector<uint8_t> decodeMeshopt(const MeshoptStream& stream) {
  std::vector<uint8_t> bytes(stream.count * stream.stride);
  const uint8_t* from = stream.bytes.data();
  const size_t size = stream.bytes.size();
  int failed = 0;
  if (stream.mode == "ATTRIBUTES") {
    if (stream.stride % 4 != 0 || stream.stride > 256)
      fail(fmt::format("byteStride {} is not allowed with mode ATTRIBUTES", stream.stride));
    failed = meshopt_decodeVertexBuffer(bytes.data(), stream.count, stream.stride, from, size);
  } else {
    if (stream.stride != 2 && stream.stride != 4)
      fail(fmt::format("byteStride {} is not allowed with mode {}", stream.stride, stream.mode));
    if (stream.mode == "TRIANGLES" && stream.count % 3 != 0)
      fail(fmt::format("the number of indices is {}, not a multiple of 3", stream.count));
    failed = stream.mode == "TRIANGLES"
                 ? meshopt_decodeIndexBuffer(bytes.data(), stream.count, stream.stride, from, size)
                 : meshopt_decodeIndexSequence(bytes.data(), stream.count, stream.stride, from, size);
  }
  if (failed != 0) fail(fmt::format("its {} bytes are damaged", size));
  applyFilter(stream, bytes.data());
  return bytes;
}

DracoMesh decodeDraco(const DracoStream& stream) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(stream.bytes.data()), stream.bytes.size());
  draco::DecoderBuffer ahead = buffer;
  draco::DracoHeader header;
  if (!draco::PointCloudDecoder::DecodeHeader(&ahead, &header).ok()) fail("it has no Draco header");
  if (header.version_major != 2 || header.version_minor != 2)
    fail(fmt::format("its version is {}.{}, not 2.2", header.version_major, header.version_minor));
  if (header.encoder_type != draco::TRIANGULAR_MESH) fail("it is not a mesh");
  draco::Mesh mesh;
  if (header.encoder_method == draco::MESH_SEQUENTIAL_ENCODING)
    decodeMesh<draco::MeshSequentialDecoder>(stream, buffer, mesh);
  else if (header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING)
    decodeMesh<draco::MeshEdgebreakerDecoder>(stream, buffer, mesh);
  else fail(fmt::format("its encoding {} is unknown", header.encoder_method));
  if (size_t(mesh.num_faces()) * 3 != stream.indices)
    fail(fmt::format("it has {} triangles, but its accessor has {} indices", mesh.num_faces(), stream.indices));
  DracoMesh result;
  switch (stream.index_type) {
    case 5121:
      result.indices = indicesOf<uint8_t>(mesh);
      break;
    case 5123:
      result.indices = indicesOf<uint16_t>(mesh);
      break;
    default:
      result.indices = indicesOf<uint32_t>(mesh);
  }
  for (const auto& [name, asked] : stream.asked) result.attributes[name] = attributeOf(mesh, name, asked);
  return result;
}

}  // namespace strobe::scene
