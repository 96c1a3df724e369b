// SPDX-License-Identifier: MIT
// The glTF validator of Khronos as an oracle: what it calls an error is refused with its place, what it accepts loads.
// It only warns of values that are none of a list (filters, modes, types), which are refused here: they count as
// errors.
#include <cstdlib>

#include "base/process.h"
#include "common/home.h"
#include "common/source.h"
#include "scene/gltf_asset.h"

namespace strobe::scene {
namespace gltf_validator_test {

namespace fs = std::filesystem;

// Where `./strobe test` puts it.
std::string modules() {
  const char* given = std::getenv("STROBE_NODE_MODULES");
  return given ? given : "";
}

bool hasValidator() {
  ProgramEnd end = run({.arguments = {"sh", "-c", "command -v node"}});
  return end.succeeded() && fs::is_directory(Path(modules()) / "gltf-validator");
}

// The validator's errors in each file.
Json errorsIn(const std::vector<Path>& files) {
  std::vector<std::string> arguments = {"node", sourceFolder() / "tests/scene/gltf_validator.js"};
  arguments.insert(arguments.end(), files.begin(), files.end());
  ProgramEnd end = run({.arguments = arguments, .environment = {"NODE_PATH=" + modules()}});
  EXPECT_TRUE(end.succeeded()) << end.errors;
  return end.succeeded() ? Json::parse(end.output) : Json::object();
}

std::string refusalOf(const Path& file) {
  try {
    loadGltf(file);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

// A second mesh, of a triangle with two joints and a morph target, shown by node 4; nodes 5 and 6 are the joints.
void addBending(Asset& asset, int times) {
  Json& json = asset.json;
  int joints = asset.add<uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, "VEC4", 4, 5121);
  int weights = asset.add<float>({1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0}, "VEC4", 4, 5126);
  int binds =
      asset.add<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1},
                       "MAT4", 16, 5126);
  int change = asset.add<float>({0, 0, 0, 0, 1, 0, 0, 0, 0}, "VEC3", 3, 5126);
  int keys = asset.add<float>({0, 1}, "SCALAR", 1, 5126);
  json["accessors"][change]["min"] = {0, 0, 0};
  json["accessors"][change]["max"] = {0, 1, 0};
  json["meshes"].push_back(
      {{"primitives", Json::array({{{"attributes", {{"POSITION", 0}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}},
                                    {"targets", Json::array({{{"POSITION", change}}})}}})},
       {"weights", {0.5}}});
  json["skins"] = Json::array({{{"joints", {5, 6}}, {"inverseBindMatrices", binds}, {"skeleton", 5}}});
  json["nodes"].push_back({{"mesh", 1}, {"skin", 0}, {"weights", {0.25}}});
  json["nodes"].push_back({{"children", {6}}});
  json["nodes"].push_back({{"translation", {0, 1, 0}}});
  for (int node : {4, 5}) json["scenes"][0]["nodes"].push_back(node);
  Json& clip = json["animations"][0];
  clip["samplers"].push_back({{"input", times}, {"output", keys}});
  clip["channels"].push_back({{"sampler", 2}, {"target", {{"node", 4}, {"path", "weights"}}}});
}

// A file with something of everything: a textured and lit triangle, an index list, two cameras, clips, what bends.
Asset everything() {
  Asset asset = triangle();
  int uvs = asset.add<float>({0, 0, 1, 0, 0, 1}, "VEC2", 2, 5126);
  int normals = asset.add<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 3, 5126);
  int indices = asset.add<uint16_t>({0, 1, 2}, "SCALAR", 1, 5123);
  int times = asset.add<float>({0, 1}, "SCALAR", 1, 5126);
  int moves = asset.add<float>({0, 0, 0, 1, 0, 0}, "VEC3", 3, 5126);
  int turns = asset.add<float>({0, 0, 0, 1, 0, 0, 1, 0}, "VEC4", 4, 5126);
  Json& json = asset.json;
  json["accessors"][0]["min"] = {0, 0, 0};
  json["accessors"][0]["max"] = {2, 2, 0};
  json["accessors"][times]["min"] = {0};
  json["accessors"][times]["max"] = {1};
  asset.primitive()["attributes"]["TEXCOORD_0"] = uvs;
  asset.primitive()["attributes"]["NORMAL"] = normals;
  asset.primitive()["indices"] = indices;
  asset.primitive()["material"] = 0;
  json["materials"] = Json::parse(R"([{"alphaMode":"MASK","alphaCutoff":0.5,"doubleSided":true,
      "emissiveFactor":[0,0,0],"pbrMetallicRoughness":{"baseColorFactor":[1,1,1,1],"metallicFactor":0,
      "roughnessFactor":1,"baseColorTexture":{"index":0,"texCoord":0,
      "extensions":{"KHR_texture_transform":{"offset":[0,0],"rotation":0,"scale":[1,1]}}}}}])");
  json["images"] = Json::array({{{"uri",
                                  "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8/"
                                  "5+hHgAHggJ/PchI7wAAAABJRU5Erk"
                                  "Jggg=="}}});
  json["samplers"] = Json::parse(R"([{"magFilter":9728,"minFilter":9984,"wrapS":33071,"wrapT":33648}])");
  json["textures"] = Json::parse(R"([{"source":0,"sampler":0}])");
  json["cameras"] = Json::parse(R"([{"type":"perspective","perspective":{"yfov":1,"znear":0.1,"aspectRatio":2}},
      {"type":"orthographic","orthographic":{"xmag":1,"ymag":1,"znear":0.1,"zfar":9}}])");
  json["nodes"] = Json::parse(R"([{"mesh":0,"children":[1],"translation":[0,0,0]},{"camera":0,"rotation":[0,0,0,1]},
      {"camera":1},{"extensions":{"KHR_lights_punctual":{"light":0}}}])");
  json["scenes"][0]["nodes"] = {0, 2, 3};
  json["extensions"]["KHR_lights_punctual"]["lights"] = Json::parse(
      R"([{"type":"spot","intensity":3,"color":[1,1,1],"range":9,"spot":{"innerConeAngle":0.1,"outerConeAngle":0.4}}])");
  json["extensionsUsed"] = {"KHR_lights_punctual", "KHR_texture_transform"};
  json["animations"] = Json::array(
      {{{"samplers", Json::array({{{"input", times}, {"output", moves}}, {{"input", times}, {"output", turns}}})},
        {"channels", Json::array({{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}},
                                  {{"sampler", 1}, {"target", {{"node", 1}, {"path", "rotation"}}}}})}}});
  addBending(asset, times);
  for (size_t i = 0; i < json["accessors"].size(); ++i) json["accessors"][i].erase("normalized");
  return asset;
}

struct Change {
  const char* pointer;
  Json value;  // a text "(gone)" takes the member away
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

TEST(GltfValidator, AgreesOnWhatIsBroken) {
  if (!hasValidator()) GTEST_SKIP() << "no node, or no gltf-validator in STROBE_NODE_MODULES";
  const Path folder = fs::temp_directory_path() / fmt::format("strobe_validated_{}", ::getpid());
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
  Json errors = errorsIn(files);
  size_t broken = 0;
  for (size_t i = 0; i < files.size(); ++i) {
    const Json& found = errors[files[i].string()];
    std::string refusal = refusalOf(files[i]);
    std::string what =
        i == 0 ? "whole" : fmt::format("{} = {}", changes()[i - 1].pointer, changes()[i - 1].value.dump());
    EXPECT_EQ(refusal.empty(), found.empty()) << what << "\n  validator: " << found.dump() << "\n  here: " << refusal;
    EXPECT_EQ(refusal.find('\n'), std::string::npos) << what;
    broken += !found.empty();
  }
  EXPECT_TRUE(errors[files[0].string()].empty()) << errors[files[0].string()];
  EXPECT_GE(broken, changes().size() * 3 / 4);
  fs::remove_all(folder);
}

TEST(GltfValidator, WhatItAcceptsLoads) {
  if (!hasValidator()) GTEST_SKIP() << "no node, or no gltf-validator in STROBE_NODE_MODULES";
  std::optional<Path> data = home().data();
  if (!data || !fs::is_directory(*data / "scenes")) GTEST_SKIP() << "no shared scenes (set STROBE_DATA)";
  std::vector<Path> files;
  for (const auto& entry : fs::recursive_directory_iterator(*data / "scenes")) {
    std::string extension = entry.path().extension().string();
    bool small = entry.is_regular_file() && entry.file_size() < 600000;
    if (small && (extension == ".glb" || extension == ".gltf")) files.push_back(entry.path());
  }
  Json errors = errorsIn(files);
  for (const Path& file : files) {
    if (errors[file.string()].empty()) {
      EXPECT_EQ(refusalOf(file), "") << file;
    }
  }
  EXPECT_GE(files.size(), 30u);
}

}  // namespace gltf_validator_test
}  // namespace strobe::scene
