// SPDX-License-Identifier: MIT
// Small assets with known contents and every kind of damage; then every file of the shared scenes, whole and truncated.
#include <cmath>
#include <cstring>

#include "base/hash.h"
#include "common/home.h"
#include "common/refusal.h"
#include "math/constants.h"
#include "scene/defaults.h"
#include "scene/gltf_asset.h"
#include "scene/motion.h"

namespace strobe::scene {
namespace gltf_test {

namespace fs = std::filesystem;

dvec3 positionOf(const Scene& scene, int vertex) {
  const Mesh& mesh = scene.meshes.at(0);
  return mesh.origin + dvec3(mesh.geometries.at(0).vertices.at(vertex).position);
}

TEST_F(Gltf, TriangleGetsFacetNormals) {
  Scene scene = load(triangle().whole());
  ASSERT_EQ(scene.meshes[0].geometries[0].indices.size(), 3u);
  EXPECT_EQ(positionOf(scene, 1), dvec3(2, 0, 0));
  EXPECT_EQ(scene.meshes[0].geometries[0].vertices[0].normal, vec3(0, 0, 1));
  EXPECT_EQ(instancesOf(scene).size(), 1u);
}

TEST_F(Gltf, StripsAndFansKeepTheirWinding) {
  for (int mode : {5, 6}) {
    Asset asset;
    std::vector<float> strip = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, fan = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    asset.add(mode == 5 ? strip : fan, "VEC3", 3, 5126);
    asset.primitive()["mode"] = mode;
    Scene scene = load(asset.whole());
    const Geometry& geometry = scene.meshes[0].geometries[0];
    ASSERT_EQ(geometry.indices.size(), 6u);
    for (const Vertex& vertex : geometry.vertices) EXPECT_EQ(vertex.normal, vec3(0, 0, 1)) << mode;
  }
}

TEST_F(Gltf, PointsAndLinesAreWarnedOf) {
  Asset asset = triangle();
  asset.primitive()["mode"] = 1;
  Scene scene = load(asset.whole());
  EXPECT_TRUE(scene.meshes[0].geometries.empty());
  EXPECT_EQ(scene.warnings.size(), 1u);
}

TEST_F(Gltf, ReadsNormalisedAndQuantisedIntegers) {
  Asset asset;
  asset.add<int16_t>({0, 0, 0, 100, 0, 0, 0, 100, 0}, "VEC3", 3, 5122);
  int uv = asset.add<uint16_t>({0, 65535, 13107, 0, 65535, 65535}, "VEC2", 2, 5123, true);
  int color = asset.add<uint8_t>({255, 0, 51, 255, 0, 0, 0, 255, 0, 0, 0, 255}, "VEC4", 4, 5121, true);
  asset.primitive()["attributes"]["TEXCOORD_0"] = uv;
  asset.primitive()["attributes"]["COLOR_0"] = color;
  asset.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  Scene scene = load(asset.whole());
  EXPECT_EQ(positionOf(scene, 1), dvec3(100, 0, 0));
  EXPECT_NEAR(scene.meshes[0].geometries[0].vertices[1].uv0.x, 0.2, 1e-6);
  EXPECT_NEAR(scene.meshes[0].geometries[0].vertices[0].color.z, 0.2, 1e-6);
}

TEST_F(Gltf, SparseAccessorsReplaceElements) {
  Asset asset = triangle();
  asset.add<uint16_t>({1}, "SCALAR", 1, 5123);
  asset.add<float>({7, 8, 9}, "VEC3", 3, 5126);
  asset.json["accessors"][0]["sparse"] = {
      {"count", 1}, {"indices", {{"bufferView", 1}, {"componentType", 5123}}}, {"values", {{"bufferView", 2}}}};
  Scene scene = load(asset.whole());
  EXPECT_NEAR(glm::distance(positionOf(scene, 1), dvec3(7, 8, 9)), 0, 1e-6);
  EXPECT_EQ(positionOf(scene, 2), dvec3(0, 2, 0));
  asset.json["accessors"][0]["sparse"]["indices"]["componentType"] = 5126;
  EXPECT_NE(failure(asset.whole()), "");
}

TEST_F(Gltf, TrianglesWithNonFinitePositionsAreDropped) {
  Asset asset;
  asset.add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, NAN, 0, 0, 0, 1, 0, 0, 0, 1}, "VEC3", 3, 5126);
  Scene scene = load(asset.whole());
  EXPECT_EQ(scene.meshes[0].geometries[0].indices.size(), 3u);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_NE(scene.warnings[0].find("meshes[0].primitives[0]: 1 triangles"), std::string::npos);
}

// Each change breaks one thing: each is refused and none crashes.
TEST_F(Gltf, DamageIsRefusedInOneLine) {
  struct Damage {
    const char* pointer;
    Json value;
  };
  const std::vector<Damage> damages = {
      {"/asset/version", "1.0"},
      {"/asset", 3},
      {"/scene", 4},
      {"/scenes/0/nodes/0", 9},
      {"/nodes/0/mesh", 1},
      {"/nodes/0/mesh", -1},
      {"/nodes/0/mesh", 0.5},
      {"/nodes/0/children", Json::array({0})},
      {"/nodes/0/children", Json::array({7})},
      {"/nodes/0/rotation", Json::array({0, 0, 0, 0})},
      {"/nodes/0/matrix", Json::array({1, 2})},
      {"/nodes/0/translation", Json::array({"x", 0, 0})},
      {"/meshes/0/primitives/0/attributes/POSITION", 5},
      {"/meshes/0/primitives/0/mode", 9},
      {"/meshes/0/primitives/0/indices", 0},
      {"/meshes/0/primitives/0/material", 0},
      {"/meshes", 1},
      {"/accessors/0/count", 4},
      {"/accessors/0/count", 0},
      {"/accessors/0/count", 4000000000u},
      {"/accessors/0/count", -1},
      {"/accessors/0/componentType", 5127},
      {"/accessors/0/componentType", 5130},
      {"/accessors/0/type", "VEC2"},
      {"/accessors/0/type", "MAT4"},
      {"/accessors/0/byteOffset", 4},
      {"/accessors/0/byteOffset", 18446744073709551615u},
      {"/accessors/0/bufferView", 3},
      {"/bufferViews/0/buffer", 2},
      {"/bufferViews/0/byteOffset", 40},
      {"/bufferViews/0/byteLength", 1000},
      {"/bufferViews/0/byteStride", 4},
      {"/bufferViews/0/byteStride", 400},
      {"/buffers/0/byteLength", 1000},
      {"/buffers/0/uri", "data:nonsense"},
      {"/buffers/0/uri", "missing.bin"},
      {"/buffers/0/uri", "http://x/y.bin"},
      {"/buffers/0/uri", "/etc/hostname"},
      {"/buffers/0/uri", "data:;base64,!!"},
      {"/extensionsRequired", Json::array({"KHR_texture_basisu"})},
      {"/cameras", Json::array({{{"type", "fisheye"}}})},
      {"/materials", Json::array({{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}})},
      {"/materials", Json::array({{{"alphaMode", "SOMETIMES"}}})},
      {"/animations",
       Json::array({{{"channels", Json::array({{{"sampler", 0}, {"target", {{"node", 0}, {"path", "scale"}}}}})}}})},
  };
  for (const Damage& damage : damages) {
    Json json = triangle().whole();
    json[Json::json_pointer(damage.pointer)] = damage.value;
    EXPECT_NE(failure(json), "") << damage.pointer << " = " << damage.value.dump().substr(0, 60);
  }
}

// A file may name files in its own folder only, also through links.
TEST_F(Gltf, FilesOutsideTheFolderAreRefused) {
  const Path folder = folder_ / "asset", outside = folder_ / "outside.bin";
  std::filesystem::create_directories(folder / "deeper");
  Asset asset = triangle();
  Json json = asset.whole();
  std::string bytes(asset.bytes.begin(), asset.bytes.end());
  for (const Path& file : {outside, folder / "deeper/own.bin"}) writeQuickly(file, bytes);
  std::filesystem::create_symlink(outside, folder / "link.bin");
  auto loaded = [&](const std::string& name, bool allow_outside) {
    json["buffers"][0]["uri"] = name;
    writeQuickly(folder / "asset.gltf", json.dump());
    return loadGltf(folder / "asset.gltf", {.allow_outside = allow_outside});
  };
  Scene scene = loaded("deeper/own.bin", false);
  ASSERT_EQ(scene.files.size(), 2u);
  EXPECT_EQ(scene.files[1].path, std::filesystem::absolute(folder / "deeper/own.bin"));
  EXPECT_EQ(scene.files[1].hash, hashText(bytes));
  for (const char* name : {"../outside.bin", "deeper/../../outside.bin", "%2e%2e/outside.bin", "link.bin"}) {
    const std::string refused = testing::refusalOf([&] { loaded(name, false); });
    EXPECT_NE(refused.find("buffers[0]"), std::string::npos) << refused;
    EXPECT_NE(refused.find("outside of the scene's folder"), std::string::npos) << refused;
    EXPECT_EQ(loaded(name, true).files.size(), 2u) << name;
  }
}

TEST_F(Gltf, AnimationMatchesItsClosedForm) {
  Asset asset = triangle();
  int times = asset.add<float>({1, 3}, "SCALAR", 1, 5126);
  int values = asset.add<float>({0, 0, 0, 4, 0, -2}, "VEC3", 3, 5126);
  asset.json["nodes"][0]["matrix"] = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 9, 9, 9, 1};
  asset.json["animations"] = Json::array(
      {{{"name", "go"},
        {"samplers", Json::array({{{"input", times}, {"output", values}}})},
        {"channels", Json::array({{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}})}}});
  Scene scene = load(asset.whole());
  EXPECT_EQ(scene.animations.at(0).duration, 3);
  supplyDefaults(scene);
  Poser poser(scene, cameraNode(scene, ""));
  dvec4 corner = dvec4(positionOf(scene, 1) - scene.meshes[0].origin, 1);
  dvec4 at = poser.at(2).world_from_instance[0] * corner;  // halfway; the scale of 2 comes from the node's matrix
  EXPECT_NEAR(at.x, 2 + 4, 1e-9);
  EXPECT_NEAR(at.z, -1, 1e-9);
}

TEST_F(Gltf, ReadsGpuInstancesLightsAndUnlit) {
  Asset asset = triangle();
  int moves = asset.add<float>({1, 0, 0, 0, 5, 0}, "VEC3", 3, 5126);
  asset.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = moves;
  asset.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
  asset.json["extensions"]["KHR_lights_punctual"]["lights"] =
      Json::array({{{"type", "directional"}, {"intensity", 100000}, {"color", {1, 1, 1}}}});
  asset.json["materials"] = Json::array({{{"extensions", {{"KHR_materials_unlit", Json::object()}}}}});
  asset.primitive()["material"] = 0;
  Scene scene = load(asset.whole());
  EXPECT_EQ(instancesOf(scene).size(), 2u);
  EXPECT_TRUE(scene.materials[0].unlit);
  EXPECT_NEAR(scene.lights[0].emitted().x, kPi, 1e-5) << "sunlight is scaled to the display's white";
  EXPECT_EQ(scene.assumptions.size(), 1u);
}

TEST(Defaults, CameraFramesTheBounds) {
  Scene scene;
  scene.materials.resize(1);
  scene.nodes.resize(1);
  scene.nodes[0].mesh = 0;
  scene.nodes[0].transform.translation = {100, 0, 0};
  Geometry box;
  for (int i = 0; i < 8; ++i) {
    Vertex vertex;
    vertex.position = {i & 1 ? 3 : -3, i & 2 ? 1 : -1, i & 4 ? 2 : -2};
    box.vertices.push_back(vertex);
    box.indices.push_back(uint32_t(i));
  }
  scene.meshes.push_back({"box", {box}, dvec3(0)});
  supplyDefaults(scene);
  ASSERT_EQ(scene.assumptions.size(), 3u);
  int camera = cameraNode(scene, "");
  dmat4 camera_from_world = glm::inverse(Poser(scene, camera).at(0).world_from_camera);
  double up = std::tan(scene.cameras[0].vertical_fov / 2), fullest = 0;
  for (const Vertex& vertex : box.vertices) {
    dvec4 seen = camera_from_world * dvec4(dvec3(vertex.position) + dvec3(100, 0, 0), 1);
    EXPECT_GT(-seen.z, scene.cameras[0].near);
    fullest = std::max({fullest, std::abs(seen.y) / (-seen.z * up), std::abs(seen.x) / (-seen.z * up * 16 / 9)});
  }
  EXPECT_LT(fullest, 1);
  EXPECT_GT(fullest, 0.75);
  size_t nodes = scene.nodes.size();
  supplyDefaults(scene);
  EXPECT_EQ(scene.nodes.size(), nodes) << "defaults are supplied once";
}

TEST(Defaults, UnlitScenesGetNoLight) {
  Scene scene;
  scene.materials.resize(1);
  scene.materials[0].unlit = true;
  scene.nodes.resize(1);
  scene.nodes[0].mesh = 0;
  scene.meshes.push_back({"empty", {Geometry{}}, dvec3(0)});
  supplyDefaults(scene);
  EXPECT_TRUE(scene.lights.empty());
}

std::vector<Path> sharedFiles() {
  std::vector<Path> files;
  std::optional<Path> data = home().data();
  if (!data || !fs::is_directory(*data / "scenes")) return files;
  for (const auto& entry : fs::recursive_directory_iterator(*data / "scenes")) {
    std::string extension = entry.path().extension().string();
    if (extension == ".glb" || extension == ".gltf") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

void expectSound(const Scene& scene) {
  for (const Mesh& mesh : scene.meshes) {
    for (const Geometry& geometry : mesh.geometries) {
      ASSERT_LT(size_t(geometry.material), scene.materials.size());
      ASSERT_EQ(geometry.indices.size() % 3, 0u);
      for (uint32_t index : geometry.indices) ASSERT_LT(index, geometry.vertices.size());
      for (const Vertex& vertex : geometry.vertices) ASSERT_NEAR(glm::length(vertex.normal), 1, 1e-4);
    }
  }
  for (const Texture& texture : scene.textures) {
    for (size_t level = 0; level < texture.levels.size(); ++level) {
      size_t texels = size_t(std::max(1, texture.width >> level)) * std::max(1, texture.height >> level);
      ASSERT_EQ(texture.levels[level].size(), 4 * texels);
    }
  }
}

TEST(SharedScenes, AllLoadAndPose) {
  std::vector<Path> files = sharedFiles();
  if (files.empty()) GTEST_SKIP() << "no shared scenes (set STROBE_DATA)";
  for (const Path& file : files) {
    SCOPED_TRACE(file.string());
    Scene scene = loadGltf(file);
    expectSound(scene);
    supplyDefaults(scene);
    EXPECT_FALSE(boundsOf(scene).empty());
    EXPECT_FALSE(lightsOf(scene).empty());
    Poser poser(scene, cameraNode(scene, ""));
    for (double time_s : {-0.5, 0.0, 0.37, 5.0}) {
      Pose pose = poser.at(time_s);
      for (const dmat4& world : pose.world_from_instance) {
        for (int c = 0; c < 4; ++c) ASSERT_TRUE(std::isfinite(glm::dot(world[c], world[c])));
      }
      EXPECT_NEAR(glm::determinant(dmat3(pose.world_from_camera)), 1, 1e-9);
    }
  }
}

// Any prefix of a file either loads or is refused in one line.
TEST(SharedScenes, TruncatedFilesAreRefused) {
  std::vector<Path> files = sharedFiles();
  if (files.empty()) GTEST_SKIP() << "no shared scenes (set STROBE_DATA)";
  const testing::TemporaryFolder temporary;
  const Path folder = temporary.path();
  int refused = 0, tried = 0;
  for (const Path& file : files) {
    std::string bytes = readText(file);
    size_t size = bytes.size();
    for (size_t length : {size_t(0), size_t(3), size_t(11), size_t(19), size_t(21), size / 7, size / 2, size - 1}) {
      writeQuickly(folder / file.filename(), std::string_view(bytes).substr(0, length));
      ++tried;
      try {
        loadGltf(folder / file.filename());
      } catch (const Error& error) {
        ++refused;
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      }
    }
  }
  EXPECT_EQ(refused, tried);
}

// Flipped bytes in small files never crash.
TEST(SharedScenes, DamagedBytesDoNotCrash) {
  std::vector<Path> files = sharedFiles();
  if (files.empty()) GTEST_SKIP() << "no shared scenes (set STROBE_DATA)";
  const testing::TemporaryFolder folder;
  uint32_t state = 1;
  auto random = [&] { return state = state * 1664525u + 1013904223u, state >> 8; };
  int loaded = 0, refused = 0;
  for (const Path& file : files) {
    std::string whole = readText(file);
    if (whole.size() > 50000 || file.extension() != ".glb") continue;
    for (int round = 0; round < 300; ++round) {
      std::string bytes = whole;
      for (int k = 0; k < 3; ++k) bytes[random() % bytes.size()] = char(random());
      writeQuickly(folder / "a.glb", bytes);
      try {
        Scene scene = loadGltf(folder / "a.glb");
        supplyDefaults(scene);
        Poser(scene, cameraNode(scene, "")).at(0.3);
        ++loaded;
      } catch (const Error&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(loaded + refused, 0);
}

}  // namespace gltf_test
}  // namespace strobe::scene
