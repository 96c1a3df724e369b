// SPDX-License-Identifier: MIT
// Broken files, shared scenes and reported files, compared with the validator.
#include "scene/gltf_validator.h"

#include "base/files.h"
#include "base/process.h"
#include "common/home.h"
#include "common/source.h"

namespace strobe::scene {
namespace gltf_validator_test {

namespace fs = std::filesystem;

struct Change {
  const char* pointer;
  Json value;  // "(gone)" removes the member
};

const std::vector<Change>& changes() {
  static const std::vector<Change> all = {
      {"/asset", "(gone)"},
      {"/asset/version", "(gone)"},
      {"/asset/version", "1.0"},
      {"/asset/version", 2},
      {"/asset/minVersion", "2.1"},
      {"/scene", 4},
      {"/scene", "main"},
      {"/scenes/0/nodes/0", 9},
      {"/scenes/0/nodes/0", 1},
      {"/scenes/0/nodes", {0, 0, 2, 3, 4, 5}},
      {"/nodes/0/mesh", 1},
      {"/nodes/0/mesh", -1},
      {"/nodes/0/mesh", 0.5},
      {"/nodes/1/camera", 2},
      {"/nodes/0/children", Json::array({0})},
      {"/nodes/0/children", Json::array({7})},
      {"/nodes/0/children", Json::array({1, 1})},
      {"/nodes/1/children", Json::array({0})},
      {"/nodes/1/rotation", {0, 0, 0, 0}},
      {"/nodes/1/rotation", {0, 0, 0, 2}},
      {"/nodes/1/rotation", {0, 0, 0}},
      {"/nodes/0/translation", {"x", 0, 0}},
      {"/nodes/0/translation", {1, 2}},
      {"/nodes/0/scale", 2},
      {"/nodes/2/matrix", {1, 2}},
      {"/nodes/2/matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 2}},
      {"/nodes/0/matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}},
      {"/nodes/3/extensions/KHR_lights_punctual/light", 1},
      {"/nodes/3/extensions/KHR_lights_punctual/light", "(gone)"},
      {"/meshes/0/primitives", "(gone)"},
      {"/meshes/0/primitives/0/attributes", "(gone)"},
      {"/meshes/0/primitives/0/attributes/POSITION", 50},
      {"/meshes/0/primitives/0/attributes/POSITION", 1},
      {"/meshes/0/primitives/0/attributes/NORMAL", 1},
      {"/meshes/0/primitives/0/attributes/NORMAL", 5},
      {"/meshes/0/primitives/0/attributes/TEXCOORD_0", 2},
      {"/meshes/0/primitives/0/mode", 9},
      {"/meshes/0/primitives/0/indices", 0},
      {"/meshes/0/primitives/0/indices", 30},
      {"/meshes/0/primitives/0/material", 4},
      {"/meshes", 1},
      {"/accessors/0/count", 4},
      {"/accessors/0/count", 0},
      {"/accessors/0/count", -1},
      {"/accessors/0/count", "three"},
      {"/accessors/0/componentType", 5130},
      {"/accessors/0/componentType", 5122},
      {"/accessors/0/componentType", "(gone)"},
      {"/accessors/0/type", "VEC2"},
      {"/accessors/0/type", "VEC5"},
      {"/accessors/0/byteOffset", 4},
      {"/accessors/0/byteOffset", 2},
      {"/accessors/0/bufferView", 30},
      {"/accessors/3/componentType", 5126},
      {"/bufferViews/0/buffer", 2},
      {"/bufferViews/0/buffer", "(gone)"},
      {"/bufferViews/0/byteOffset", 4000},
      {"/bufferViews/0/byteLength", 100000},
      {"/bufferViews/0/byteLength", 0},
      {"/bufferViews/0/byteStride", 4},
      {"/bufferViews/0/byteStride", 400},
      {"/bufferViews/0/byteStride", 13},
      {"/buffers/0/byteLength", 100000},
      {"/buffers/0/byteLength", 0},
      {"/buffers/0/uri", "missing.bin"},
      {"/buffers/0/uri", "data:application/octet-stream;base64,!!"},
      {"/images/0/uri", "(gone)"},
      {"/images/0/uri", "missing.png"},
      {"/textures/0/source", 3},
      {"/textures/0/sampler", 3},
      {"/samplers/0/magFilter", 9984},
      {"/samplers/0/minFilter", 1},
      {"/samplers/0/wrapS", 1},
      {"/samplers/0/wrapT", "clamp"},
      {"/materials/0/alphaMode", "SOMETIMES"},
      {"/materials/0/alphaMode", 3},
      {"/materials/0/alphaCutoff", -1},
      {"/materials/0/doubleSided", 1},
      {"/materials/0/emissiveFactor", {1, 2}},
      {"/materials/0/emissiveFactor", {2, 0, 0}},
      {"/materials/0/pbrMetallicRoughness", 1},
      {"/materials/0/pbrMetallicRoughness/baseColorFactor", {1, 1, 1}},
      {"/materials/0/pbrMetallicRoughness/baseColorFactor", {2, 1, 1, 1}},
      {"/materials/0/pbrMetallicRoughness/metallicFactor", 2},
      {"/materials/0/pbrMetallicRoughness/roughnessFactor", "rough"},
      {"/materials/0/pbrMetallicRoughness/baseColorTexture/index", 8},
      {"/materials/0/pbrMetallicRoughness/baseColorTexture/index", "(gone)"},
      {"/materials/0/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/scale", {1}},
      {"/cameras/0/type", "fisheye"},
      {"/cameras/0/type", "(gone)"},
      {"/cameras/0/perspective", "(gone)"},
      {"/cameras/0/perspective/yfov", "(gone)"},
      {"/cameras/0/perspective/yfov", 0},
      {"/cameras/0/perspective/znear", 0},
      {"/cameras/0/perspective/znear", "(gone)"},
      {"/cameras/0/perspective/zfar", 0.05},
      {"/cameras/0/perspective/aspectRatio", 0},
      {"/cameras/1/orthographic/ymag", 0},
      {"/cameras/1/orthographic/xmag", "(gone)"},
      {"/cameras/1/orthographic/zfar", 0.05},
      {"/cameras/1/orthographic/znear", -1},
      {"/extensions/KHR_lights_punctual/lights/0/type", "lava"},
      {"/extensions/KHR_lights_punctual/lights/0/color", {1, 1}},
      {"/extensions/KHR_lights_punctual/lights/0/intensity", -1},
      {"/extensions/KHR_lights_punctual/lights/0/range", 0},
      {"/extensions/KHR_lights_punctual/lights/0/spot/outerConeAngle", 3},
      {"/extensions/KHR_lights_punctual/lights/0/spot/innerConeAngle", 0.5},
      {"/extensions/KHR_lights_punctual/lights/0/spot", "(gone)"},
      {"/animations/0/channels", "(gone)"},
      {"/animations/0/samplers", "(gone)"},
      {"/animations/0/channels/0/sampler", 9},
      {"/animations/0/channels/0/sampler", 1},
      {"/animations/0/channels/0/target/node", 9},
      {"/animations/0/channels/0/target", "(gone)"},
      {"/animations/0/channels/1/target", {{"node", 0}, {"path", "translation"}}},
      {"/animations/0/samplers/0/interpolation", "SMOOTH"},
      {"/animations/0/samplers/0/interpolation", "CUBICSPLINE"},
      {"/animations/0/samplers/0/input", 5},
      {"/animations/0/samplers/0/input", "(gone)"},
      {"/animations/0/samplers/0/output", 0},
      {"/animations/0/samplers/0/output", 50},
      {"/nodes/4/skin", 1},
      {"/nodes/4/mesh", "(gone)"},
      {"/nodes/4/mesh", 0},
      {"/nodes/4/weights", {1, 2}},
      {"/nodes/4/weights", {"x"}},
      {"/nodes/0/weights", {1}},
      {"/nodes/2/skin", 0},
      {"/meshes/1/weights", {1, 2}},
      {"/meshes/1/primitives/0/attributes/JOINTS_0", "(gone)"},
      {"/meshes/1/primitives/0/attributes/WEIGHTS_0", "(gone)"},
      {"/meshes/1/primitives/0/attributes/JOINTS_0", 7},
      {"/meshes/1/primitives/0/attributes/WEIGHTS_0", 0},
      {"/meshes/1/primitives/0/attributes/WEIGHTS_1", 7},
      {"/meshes/1/primitives/0/targets/0/POSITION", 50},
      {"/meshes/1/primitives/0/targets/0/POSITION", 4},
      {"/meshes/1/primitives/0/targets/0/NORMAL", 9},
      {"/meshes/1/primitives/0/targets/0", 5},
      {"/meshes/1/primitives/0/targets", "(gone)"},
      {"/skins/0/joints", "(gone)"},
      {"/skins/0/joints", {5, 5}},
      {"/skins/0/joints", {5, 60}},
      {"/skins/0/joints", Json::array({5})},
      {"/skins/0/joints", {5, 6, 4}},
      {"/skins/0/skeleton", 60},
      {"/skins/0/inverseBindMatrices", 0},
      {"/skins/0/inverseBindMatrices", "(gone)"},
      {"/animations/0/channels/2/target/node", 0},
      {"/animations/0/channels/2/sampler", 0},
      {"/animations/0/samplers/2/interpolation", "CUBICSPLINE"},
      {"/animations/0/samplers/2/interpolation", "STEP"},
      {"/extensionsRequired", Json::array({"KHR_texture_transform"})},
      {"/extensionsRequired", "KHR_texture_transform"},
      {"/materials/0/doubleSided", false},
      {"/materials/0/alphaMode", "BLEND"},
      {"/meshes/0/primitives/0/mode", 6},
      {"/nodes/0/scale", {-1, 2, 3}},
      {"/samplers/0", Json::object()},
      {"/textures/0/sampler", "(gone)"},
      {"/animations/0/samplers/0/interpolation", "STEP"},
      {"/cameras/0/perspective/zfar", 100},
      {"/scene", "(gone)"},
  };
  return all;
}

TEST(GltfValidator, ExceptionsAreDocumented) {
  const std::string page = readText(sourceFolder() / "docs/gltf.md");
  for (const auto* list : {&accepted(), &refusedAllTheSame()})
    for (const auto& [what, phrase] : *list) EXPECT_NE(page.find(phrase), std::string::npos) << phrase;
}

TEST(GltfValidator, AgreesOnBrokenFiles) {
  if (!hasValidator()) GTEST_SKIP() << "no node, or no gltf-validator in STROBE_NODE_MODULES";
  const testing::TemporaryFolder folder;
  const Json whole = everything().whole();
  std::vector<Path> files = {folder / "whole.gltf"};
  writeQuickly(files[0], whole.dump());
  for (size_t i = 0; i < changes().size(); ++i) {
    Json json = whole;
    Json::json_pointer at(changes()[i].pointer);
    if (changes()[i].value == Json("(gone)")) json.at(at.parent_pointer()).erase(at.back());
    else json[at] = changes()[i].value;
    files.push_back(folder / fmt::format("{:03}.gltf", i));
    writeQuickly(files.back(), json.dump());
  }
  const Tally tally = expectAgreement(files, [](size_t i) {
    return i == 0 ? "whole" : fmt::format("{} = {}", changes()[i - 1].pointer, changes()[i - 1].value.dump());
  });
  EXPECT_EQ(refusalOf(files[0]), "");
  EXPECT_GE(tally.refused, changes().size() * 7 / 10);
}

std::vector<Path> gltfFilesBelow(const Path& folder) {
  std::vector<Path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().string();
    if (entry.is_regular_file() && (hasExtension(name, ".glb") || hasExtension(name, ".gltf")))
      files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(GltfValidator, AgreesOnSharedScenes) {
  if (!hasValidator()) GTEST_SKIP() << "no node, or no gltf-validator in STROBE_NODE_MODULES";
  std::optional<Path> data = home().data();
  if (!data || !fs::is_directory(*data / "scenes")) GTEST_SKIP() << "no shared scenes (set STROBE_DATA)";
  const std::vector<Path> files = gltfFilesBelow(*data / "scenes");
  const Tally tally = expectAgreement(files, [&](size_t i) { return files[i].string(); });
  EXPECT_GE(tally.loaded, 30u);
}

// Small files written by scripts beside them, each with one fault or oddity that other programs failed on.
TEST(GltfValidator, AgreesOnReportedFiles) {
  if (!hasValidator()) GTEST_SKIP() << "no node, or no gltf-validator in STROBE_NODE_MODULES";
  std::optional<Path> data = home().data();
  if (!data || !fs::is_directory(*data / "reports")) GTEST_SKIP() << "no shared reports (set STROBE_DATA)";
  const testing::TemporaryFolder temporary;
  const Path folder = temporary.path();
  for (const char* name : {"r06_upper_case", "r09_dropped_attributes", "r10_validator_errors", "r20_zero_weights",
                           "r24_compressed_optional", "r25_uris", "r48_skins", "r58_odd_files"}) {
    if (!fs::is_directory(*data / "reports" / name)) continue;
    fs::copy(*data / "reports" / name, folder / name, fs::copy_options::recursive);
    fs::permissions(folder / name, fs::perms::owner_all, fs::perm_options::add);
    const ProgramEnd end =
        run({.arguments = {"sh", "-c", "cd \"$1\" && exec python3 -B make.py", "sh", folder / name}});
    EXPECT_TRUE(end.succeeded()) << name << ": " << end.errors;
  }
  const std::vector<Path> files = gltfFilesBelow(folder);
  const Tally tally = expectAgreement(files, [&](size_t i) { return files[i].string(); });
  fmt::print("{} files refused, {} load without errors, {} with listed ones\n", tally.refused, tally.loaded,
             tally.listed);
  EXPECT_GE(files.size(), 100u);
}

}  // namespace gltf_validator_test
}  // namespace strobe::scene
