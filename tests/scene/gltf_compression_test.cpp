// SPDX-License-Identifier: MIT
// Compressed meshes, encoded here by the libraries' encoders and compared with the original mesh.
#include <draco/compression/expert_encode.h>
#include <meshoptimizer.h>

#include <array>
#include <cmath>
#include <cstring>

#include "scene/gltf_asset.h"

namespace strobe::scene {
namespace gltf_compression_test {

constexpr int kSide = 9;  // vertices along an edge of the grid

std::vector<float> gridPositions() {
  std::vector<float> positions;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      positions.insert(positions.end(), {float(x) * 0.37f, float(y) * 0.21f, std::sin(float(x * y))});
  return positions;
}

std::vector<float> gridNormals() {
  std::vector<float> normals;
  for (int i = 0; i < kSide * kSide; ++i) {
    const double a = i * 0.7, b = std::cos(i * 0.3);
    const double c = std::sqrt(1 - b * b);
    normals.insert(normals.end(), {float(std::cos(a) * c), float(std::sin(a) * c), float(b)});
  }
  return normals;
}

std::vector<uint32_t> gridIndices() {
  std::vector<uint32_t> indices;
  for (uint32_t y = 0; y + 1 < kSide; ++y)
    for (uint32_t x = 0; x + 1 < kSide; ++x) {
      const uint32_t a = y * kSide + x, b = a + 1, c = a + kSide, d = c + 1;
      indices.insert(indices.end(), {a, b, d, a, d, c});
    }
  return indices;
}

// The grid, uncompressed.
Asset grid() {
  Asset asset;
  asset.add<float>(gridPositions(), "VEC3", 3, 5126);
  asset.primitive()["attributes"]["NORMAL"] = asset.add<float>(gridNormals(), "VEC3", 3, 5126);
  asset.primitive()["indices"] = asset.add<uint32_t>(gridIndices(), "SCALAR", 1, 5125);
  return asset;
}

const Geometry& geometryOf(const Scene& scene) { return scene.meshes.at(0).geometries.at(0); }

void expectSameVertices(const Geometry& one, const Geometry& other) {
  ASSERT_EQ(one.vertices.size(), other.vertices.size());
  for (size_t i = 0; i < one.vertices.size(); ++i) {
    EXPECT_EQ(one.vertices[i].position, other.vertices[i].position) << i;
    EXPECT_EQ(one.vertices[i].normal, other.vertices[i].normal) << i;
  }
}

// --- meshopt ------------------------------------------------------------------------------------------------------

struct Coded {
  std::string mode = "ATTRIBUTES", filter = "NONE";
  std::vector<uint8_t> bytes;
};

std::vector<uint8_t> codedVertices(const uint8_t* from, size_t count, size_t stride) {
  std::vector<uint8_t> bytes(meshopt_encodeVertexBufferBound(count, stride));
  bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), from, count, stride));
  return bytes;
}

std::vector<uint8_t> codedIndices(const std::vector<uint32_t>& indices, const std::string& mode) {
  const size_t vertices = kSide * kSide;
  std::vector<uint8_t> bytes;
  if (mode == "TRIANGLES") {
    bytes.resize(meshopt_encodeIndexBufferBound(indices.size(), vertices));
    bytes.resize(meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), indices.data(), indices.size()));
  } else {
    bytes.resize(meshopt_encodeIndexSequenceBound(indices.size(), vertices));
    bytes.resize(meshopt_encodeIndexSequence(bytes.data(), bytes.size(), indices.data(), indices.size()));
  }
  return bytes;
}

// The asset with each view compressed, in buffer 0; the uncompressed views refer to buffer 1, which has no bytes.
Json compressed(const Asset& asset, const std::string& index_mode) {
  Json json = asset.json;
  std::vector<uint8_t> all;
  for (size_t i = 0; i < json["bufferViews"].size(); ++i) {
    Json& view = json["bufferViews"][i];
    const Json& accessor = json["accessors"][i];
    const size_t count = accessor["count"], length = view["byteLength"], stride = length / count;
    const bool indices = accessor["type"] == "SCALAR";
    std::vector<uint8_t> bytes = indices
                                     ? codedIndices(gridIndices(), index_mode)
                                     : codedVertices(asset.bytes.data() + size_t(view["byteOffset"]), count, stride);
    view["extensions"]["EXT_meshopt_compression"] = {
        {"buffer", 0},          {"byteOffset", all.size()}, {"byteLength", bytes.size()},
        {"byteStride", stride}, {"count", count},           {"mode", indices ? index_mode : "ATTRIBUTES"}};
    view["buffer"] = 1;
    all.insert(all.end(), bytes.begin(), bytes.end());
    while (all.size() % 4) all.push_back(0);
  }
  json["extensionsUsed"] = {"EXT_meshopt_compression"};
  json["extensionsRequired"] = {"EXT_meshopt_compression"};
  json["buffers"] = Json::array(
      {{{"byteLength", all.size()}, {"uri", "data:application/octet-stream;base64," + base64(all)}},
       {{"byteLength", asset.bytes.size()}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}});
  return json;
}

TEST_F(Gltf, MeshoptEqualsTheMeshBitForBit) {
  const Scene plain = load(grid().whole());
  for (const char* mode : {"INDICES", "TRIANGLES"}) {
    const Scene scene = load(compressed(grid(), mode));
    expectSameVertices(geometryOf(scene), geometryOf(plain));
    const std::vector<uint32_t>&now = geometryOf(scene).indices, &before = geometryOf(plain).indices;
    ASSERT_EQ(now.size(), before.size());
    // Mode TRIANGLES may start a triangle at another of its corners.
    for (size_t t = 0; t < now.size(); t += 3) {
      size_t turn = 0;
      while (turn < 2 && now[t + turn] != before[t]) ++turn;
      EXPECT_TRUE(turn == 0 || std::string(mode) == "TRIANGLES");
      for (size_t k = 0; k < 3; ++k) EXPECT_EQ(now[t + (k + turn) % 3], before[t + k]) << mode << " " << t;
    }
  }
}

// A view of the asset replaced by filtered numbers.
Json filtered(Asset asset, int view, const std::vector<uint8_t>& raw, size_t count, const std::string& filter) {
  const std::vector<uint8_t> bytes = codedVertices(raw.data(), count, raw.size() / count);
  const size_t at = asset.bytes.size();
  asset.bytes.insert(asset.bytes.end(), bytes.begin(), bytes.end());
  while (asset.bytes.size() % 4) asset.bytes.push_back(0);
  asset.json["bufferViews"][view]["byteLength"] = raw.size();
  asset.json["bufferViews"][view]["byteOffset"] = 0;
  asset.json["bufferViews"][view]["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0},
                                                                              {"byteOffset", at},
                                                                              {"byteLength", bytes.size()},
                                                                              {"byteStride", raw.size() / count},
                                                                              {"count", count},
                                                                              {"mode", "ATTRIBUTES"},
                                                                              {"filter", filter}};
  asset.json["extensionsUsed"] = {"EXT_meshopt_compression", "KHR_mesh_quantization"};
  return asset.whole();
}

// Mantissa times a power of two: exponent in the upper byte, mantissa in the lower bytes.
TEST_F(Gltf, MeshoptExponentsMatchTheirClosedForm) {
  const Asset asset = grid();
  std::vector<uint8_t> raw;
  for (int i = 0; i < 3 * kSide * kSide; ++i) {
    const int exponent = i % 7 - 3, mantissa = (i * 37) % 1000 - 500;
    const uint32_t word = uint32_t(exponent) << 24 | (uint32_t(mantissa) & 0xffffff);
    for (int k = 0; k < 4; ++k) raw.push_back(uint8_t(word >> (8 * k)));
  }
  const Scene scene = load(filtered(asset, 0, raw, kSide * kSide, "EXPONENTIAL"));
  const Mesh& mesh = scene.meshes.at(0);
  for (size_t v = 0; v < kSide * kSide; ++v)
    for (int c = 0; c < 3; ++c) {
      const int i = int(3 * v) + c;
      const double wanted = std::ldexp((i * 37) % 1000 - 500, i % 7 - 3);
      EXPECT_NEAR(mesh.origin[c] + double(geometryOf(scene).vertices[v].position[c]), wanted, 4000 * 1e-6) << i;
    }
}

TEST_F(Gltf, MeshoptOctahedralNormalsAreWithinTheirStep) {
  Asset asset = grid();
  const std::vector<float> normals = gridNormals();
  std::vector<float> four;
  for (size_t i = 0; i < normals.size(); i += 3)
    four.insert(four.end(), {normals[i], normals[i + 1], normals[i + 2], 0});
  std::vector<uint8_t> raw(8 * kSide * kSide);
  meshopt_encodeFilterOct(raw.data(), kSide * kSide, 8, 16, four.data());
  asset.json["accessors"][1]["componentType"] = 5122;
  asset.json["accessors"][1]["normalized"] = true;
  asset.json["bufferViews"][1]["byteStride"] = 8;
  const Scene scene = load(filtered(asset, 1, raw, kSide * kSide, "OCTAHEDRAL"));
  for (size_t v = 0; v < kSide * kSide; ++v) {
    const vec3 wanted(normals[3 * v], normals[3 * v + 1], normals[3 * v + 2]);
    EXPECT_NEAR(glm::distance(geometryOf(scene).vertices[v].normal, wanted), 0, 4.0 / 32767) << v;  // 15 bits a side
  }
}

TEST_F(Gltf, MeshoptQuaternionsAreWithinTheirStep) {
  Asset asset = grid();
  const float quarter = std::sqrt(0.5f);
  const std::vector<float> turns = {0, 0, 0, 1, quarter, 0, 0, quarter, 0.5f, 0.5f, 0.5f, 0.5f};
  const int accessor = asset.add<int16_t>(std::vector<int16_t>(12), "VEC4", 4, 5122, true);
  std::vector<uint8_t> raw(8 * 3);
  meshopt_encodeFilterQuat(raw.data(), 3, 8, 16, turns.data());
  asset.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["ROTATION"] = accessor;
  Json json = filtered(asset, 3, raw, 3, "QUATERNION");
  json["extensionsUsed"].push_back("EXT_mesh_gpu_instancing");
  const Scene scene = load(json);
  ASSERT_EQ(scene.nodes[0].instances.size(), 3u);
  for (size_t i = 0; i < 3; ++i) {
    const dmat3 wanted = glm::mat3_cast(dquat(turns[4 * i + 3], turns[4 * i], turns[4 * i + 1], turns[4 * i + 2]));
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(glm::distance(dmat3(scene.nodes[0].instances[i])[c], wanted[c]), 0, 1e-3) << i;
  }
}

TEST_F(Gltf, MeshoptHeadersThatDisagreeAreRefused) {
  const Json whole = compressed(grid(), "INDICES");
  const struct {
    const char* member;
    Json value;
    const char* said;
  } changes[] = {{"count", 82, "82 elements of 12 bytes do not match the 972 bytes of the view"},
                 {"count", 1u << 30, "needs 12.0 GiB of memory"},
                 {"byteStride", 16, "81 elements of 16 bytes do not match the 972 bytes of the view"},
                 {"byteStride", 400, "'byteStride' is 400, not from 1 to 256"},
                 {"byteLength", 20, "its 20 bytes are damaged"},
                 {"byteLength", 1000000, "1000000 bytes at byte 0 do not fit in a buffer of"},
                 {"mode", "TRIANGLES", "byteStride 12 is not allowed with mode TRIANGLES"},
                 {"mode", "STRIPS", "mode 'STRIPS' is unknown"},
                 {"filter", "QUATERNION", "filter QUATERNION is not allowed with elements of 12 bytes"},
                 {"buffer", 1, "its buffer is a fallback"},
                 {"buffer", 2, "'buffer' is 2, but the file has 2 buffers"}};
  for (const auto& [member, value, said] : changes) {
    Json json = whole;
    json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"][member] = value;
    const std::string text = failure(json);
    EXPECT_NE(text.find("bufferViews[0]"), std::string::npos) << text;
    EXPECT_NE(text.find(said), std::string::npos) << text;
  }
}

TEST_F(Gltf, ViewsOfAFallbackMustBeCompressed) {
  Json json = compressed(grid(), "INDICES");
  json["bufferViews"][0].erase("extensions");
  const std::string text = failure(json);
  EXPECT_NE(text.find("bufferViews[0]: is not compressed, but its buffer is a fallback"), std::string::npos) << text;
}

// --- Draco --------------------------------------------------------------------------------------------------------

template <class T>
int addAttribute(draco::Mesh& mesh, draco::GeometryAttribute::Type type, draco::DataType data, int width,
                 const std::vector<T>& values) {
  draco::GeometryAttribute attribute;
  attribute.Init(type, nullptr, uint8_t(width), data, false, int64_t(sizeof(T)) * width, 0);
  const int id = mesh.AddAttribute(attribute, true, mesh.num_points());
  for (uint32_t i = 0; i < mesh.num_points(); ++i)
    mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i), &values[size_t(i) * size_t(width)]);
  return id;
}

// The grid as a Draco stream; bits of quantisation, 0 for unquantised.
std::vector<uint8_t> dracoBytes(int method, int bits) {
  draco::Mesh mesh;
  mesh.set_num_points(kSide * kSide);
  const std::vector<uint32_t> indices = gridIndices();
  for (size_t i = 0; i < indices.size(); i += 3)
    mesh.AddFace({draco::PointIndex(indices[i]), draco::PointIndex(indices[i + 1]), draco::PointIndex(indices[i + 2])});
  addAttribute(mesh, draco::GeometryAttribute::POSITION, draco::DT_FLOAT32, 3, gridPositions());
  addAttribute(mesh, draco::GeometryAttribute::NORMAL, draco::DT_FLOAT32, 3, gridNormals());
  draco::ExpertEncoder encoder(mesh);
  encoder.SetEncodingMethod(method);
  for (int attribute = 0; attribute < 2 && bits > 0; ++attribute) encoder.SetAttributeQuantization(attribute, bits);
  draco::EncoderBuffer buffer;
  const draco::Status status = encoder.EncodeToBuffer(&buffer);
  EXPECT_TRUE(status.ok()) << status.error_msg_string();
  return {buffer.data(), buffer.data() + buffer.size()};
}

Json dracoAsset(const std::vector<uint8_t>& stream) {
  Asset asset = grid();
  asset.bytes = stream;
  for (Json& accessor : asset.json["accessors"]) accessor.erase("bufferView");
  asset.json["bufferViews"] = Json::array({{{"buffer", 0}, {"byteLength", stream.size()}}});
  asset.primitive()["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0},
                                                                   {"attributes", {{"POSITION", 0}, {"NORMAL", 1}}}};
  asset.json["extensionsUsed"] = {"KHR_draco_mesh_compression"};
  asset.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  return asset.whole();
}

TEST_F(Gltf, SequentialDracoEqualsTheMeshBitForBit) {
  const Scene plain = load(grid().whole());
  const Scene scene = load(dracoAsset(dracoBytes(draco::MESH_SEQUENTIAL_ENCODING, 0)));
  expectSameVertices(geometryOf(scene), geometryOf(plain));
  EXPECT_EQ(geometryOf(scene).indices, geometryOf(plain).indices);
}

// Corners of all triangles in an order independent of the order of vertices and triangles.
std::vector<std::array<dvec3, 3>> trianglesOf(const Scene& scene) {
  const Geometry& geometry = geometryOf(scene);
  std::vector<std::array<dvec3, 3>> triangles;
  auto before = [](const dvec3& a, const dvec3& b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); };
  for (size_t t = 0; t < geometry.indices.size(); t += 3) {
    std::array<dvec3, 3> corners;
    for (size_t k = 0; k < 3; ++k) {
      corners[k] = scene.meshes[0].origin + dvec3(geometry.vertices[geometry.indices[t + k]].position);
      // Columns are 0.37 and rows 0.21 apart, far more than a quantisation step.
      corners[k].x = std::round(corners[k].x / 0.37) + 1e-4 * corners[k].x;
      corners[k].y = std::round(corners[k].y / 0.21) + 1e-4 * corners[k].y;
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end(), before), corners.end());
    triangles.push_back(corners);
  }
  auto key = [](const std::array<dvec3, 3>& corners) {
    std::array<double, 6> numbers;
    for (size_t k = 0; k < 3; ++k)
      numbers[2 * k] = std::round(corners[k].x), numbers[2 * k + 1] = std::round(corners[k].y);
    return numbers;
  };
  std::sort(triangles.begin(), triangles.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  return triangles;
}

TEST_F(Gltf, QuantisedDracoIsWithinItsStep) {
  const auto wanted = trianglesOf(load(grid().whole()));
  for (int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING})
    for (int bits : {11, 16}) {
      const auto found = trianglesOf(load(dracoAsset(dracoBytes(method, bits))));
      ASSERT_EQ(found.size(), wanted.size());
      // The largest extent of the grid, 8 columns, has 2^bits - 1 steps; the error is at most half a step.
      const double step = 8 * 0.37 / (std::pow(2.0, bits) - 1);
      for (size_t t = 0; t < wanted.size(); ++t)
        for (size_t k = 0; k < 3; ++k) {
          EXPECT_NEAR(found[t][k].x, wanted[t][k].x, 1e-4 * step) << t;
          EXPECT_NEAR(found[t][k].y, wanted[t][k].y, 1e-4 * step) << t;
          EXPECT_NEAR(found[t][k].z, wanted[t][k].z, 0.5 * step + 1e-6) << t;
        }
    }
}

TEST_F(Gltf, DracoHeadersThatDisagreeAreRefused) {
  const std::string extension = "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression";
  const struct {
    std::string pointer;
    Json value;
    const char* said;
  } changes[] = {{"/accessors/2/count", 30, "it has 128 triangles, but its accessor has 30 indices"},
                 {"/accessors/0/count", 82, "NORMAL has 81 elements, not 82"},
                 {"/accessors/0/type", "VEC2", "POSITION has 3 components, but its accessor has 2"},
                 {"/accessors/1/componentType", 5123, "the type of NORMAL differs from the type of its accessor"},
                 {"/accessors/2/componentType", 5121, ""},
                 {"/meshes/0/primitives/0/mode", 5, "its primitive is not a list of triangles"},
                 {extension + "/attributes/NORMAL", 7, "it has no attribute 7 for NORMAL"},
                 {extension + "/attributes/COLOR_0", 1, "its primitive has no attribute COLOR_0"},
                 {extension + "/bufferView", 1, "'bufferView' is 1, but the file has 1 bufferViews"}};
  for (int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING}) {
    const Json whole = dracoAsset(dracoBytes(method, 11));
    for (const auto& [pointer, value, said] : changes) {
      Json json = whole;
      json[Json::json_pointer(pointer)] = value;
      const std::string text = failure(json);
      const bool placed =
          text.find("meshes[0].primitives[0].extensions.KHR_draco_mesh_compression") != std::string::npos;
      EXPECT_TRUE(placed || !*said) << text;
      EXPECT_NE(text.find(said), std::string::npos) << pointer << ": " << text;
    }
  }
}

// A header that claims a billion triangles, with matching accessors: refused by the sum of memory before decoding.
TEST_F(Gltf, DracoCountsAreLimitedBeforeDecoding) {
  Json json = dracoAsset(dracoBytes(draco::MESH_SEQUENTIAL_ENCODING, 11));
  for (int accessor : {0, 1, 2}) json["accessors"][accessor]["count"] = 300000000;
  const std::string text = failure(json);
  EXPECT_NE(text.find("meshes[0].primitives[0]: needs "), std::string::npos) << text;
}

// --- damage -------------------------------------------------------------------------------------------------------

// Streams with changed bytes or a cut: each loads or is refused in one line (`failure` expects one), and takes no more
// memory than its accessors state.
TEST_F(Gltf, DamagedStreamsAreRefusedInOneLine) {
  uint32_t state = 7;
  auto random = [&] { return state = state * 1664525u + 1013904223u, state >> 8; };
  const std::string prefix = "data:application/octet-stream;base64,";
  int refused = 0, tried = 0;
  auto damage = [&](std::vector<uint8_t> bytes, auto&& assetOf) {
    const size_t kept = random() % 3 == 0 ? random() % bytes.size() : bytes.size();
    for (size_t i = kept; i < bytes.size(); ++i) bytes[i] = 0;
    for (int k = 0; k < 2; ++k) bytes[random() % bytes.size()] = uint8_t(random());
    ++tried;
    refused += !failure(assetOf(bytes)).empty();
  };
  for (int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING}) {
    const std::vector<uint8_t> whole = dracoBytes(method, 11);
    for (int round = 0; round < 150; ++round) damage(whole, dracoAsset);
  }
  for (const char* mode : {"INDICES", "TRIANGLES"}) {
    Json json = compressed(grid(), mode);
    const size_t length = json["buffers"][0]["byteLength"];
    std::vector<uint8_t> bytes;
    for (Json& view : json["bufferViews"]) {
      const Json& stream = view["extensions"]["EXT_meshopt_compression"];
      bytes.resize(stream["byteOffset"]);
      const Asset asset = grid();
      const std::vector<uint8_t> part =
          stream["mode"] == "ATTRIBUTES"
              ? codedVertices(asset.bytes.data() + size_t(view["byteOffset"]), stream["count"], stream["byteStride"])
              : codedIndices(gridIndices(), mode);
      bytes.insert(bytes.end(), part.begin(), part.end());
    }
    bytes.resize(length);
    for (int round = 0; round < 100; ++round)
      damage(bytes, [&](const std::vector<uint8_t>& damaged) {
        json["buffers"][0]["uri"] = prefix + base64(damaged);
        return json;
      });
  }
  EXPECT_GT(refused, tried / 4);
}

}  // namespace gltf_compression_test
}  // namespace strobe::scene
