// SPDX-License-Identifier: MIT
// The glTF validator of Khronos as an oracle: what it calls an error is refused with its place, what it accepts loads;
// exceptions are listed here and in docs/gltf.md. It only warns of values that are none of a list (filters, modes,
// types), which are refused here: they count as errors.
#include <cstdlib>
#include <functional>
#include <map>
#include <regex>

#include "base/extension.h"
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

// The validator's errors in each file, of one process.
std::map<std::string, std::vector<std::string>> errorsIn(const std::vector<Path>& files) {
  const std::string script = sourceFolder() / "tests/scene/gltf_validator.js";
  const ProgramEnd end =
      run({.arguments = {"node", script},
           .environment = {"NODE_PATH=" + modules()},
           .input = fmt::format("{}", fmt::join(std::vector<std::string>(files.begin(), files.end()), "\n"))});
  EXPECT_TRUE(end.succeeded()) << end.errors;
  return end.succeeded() ? Json::parse(end.output).get<std::map<std::string, std::vector<std::string>>>()
                         : std::map<std::string, std::vector<std::string>>();
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

// Errors of the validator with which a file may load, by code and JSON pointer, and where docs/gltf.md lists them.
const std::vector<std::pair<std::regex, std::string>>& accepted() {
  auto of = [](const std::string& text) { return std::regex(text, std::regex::optimize); };
  static const std::vector<std::pair<std::regex, std::string>> all = {
      {of("EMPTY_ENTITY .*"), "empty lists"},
      {of("DUPLICATE_ELEMENTS /extensions(Used|Required)/.*"), "an extension that is listed twice"},
      {of("(NON_REQUIRED_EXTENSION|UNUSED_EXTENSION_REQUIRED) .*"),
       "only one of `extensionsUsed` and `extensionsRequired`"},
      {of("MESH_PRIMITIVE_POSITION_ACCESSOR_WITHOUT_BOUNDS .*"), "`min` and `max`"},
      {of("ANIMATION_SAMPLER_INPUT_ACCESSOR_WITHOUT_BOUNDS .*"), "`min` and `max`"},
      {of("ACCESSOR_(MIN_MISMATCH|MAX_MISMATCH|ELEMENT_OUT_OF_MIN_BOUND|ELEMENT_OUT_OF_MAX_BOUND) .*"),
       "`min` and `max`"},
      {of("ACCESSOR_VECTOR3_NON_UNIT .*"), "normals and tangents that are not of length 1"},
      {of("ACCESSOR_ANIMATION_SAMPLER_OUTPUT_NON_NORMALIZED_QUATERNION .*"), "keyed quaternions"},
      {of("ROTATION_NON_UNIT .*"), "quaternions of nodes that miss length 1 by less than a hundredth"},
      {of("ACCESSOR_(WEIGHTS_NON_NORMALIZED|JOINTS_INDEX_DUPLICATE) .*"),
       "weights of vertices that do not add up to 1"},
      {of("ACCESSOR_NON_CLAMPED .*"), "colours above 1"},
      {of("ACCESSOR_INVALID_FLOAT .*"), "numbers that are not finite"},
      {of("NODE_MATRIX_NON_TRS .*"), "a matrix with shear or without volume"},
      {of("ANIMATION_CHANNEL_TARGET_NODE_MATRIX .*"), "an animated node with a matrix"},
      {of("(SKIN_NO_COMMON_ROOT|NODE_SKIN_NO_SCENE|SKIN_SKELETON_INVALID) .*"),
       "joints of a skin without a common root"},
      {of("ACCESSOR_(OFFSET_ALIGNMENT|TOTAL_OFFSET_ALIGNMENT|MATRIX_ALIGNMENT) .*"), "alignment"},
      {of("MESH_PRIMITIVE_ACCESSOR_(UNALIGNED|WITHOUT_BYTESTRIDE) .*"), "alignment"},
      {of("BUFFER_VIEW_(INVALID|TOO_BIG)_BYTE_STRIDE .*"), "alignment"},
      {of("[A-Z_]*_WITH_BYTESTRIDE .*"), "alignment"},
      {of("Invalid argument\\(s\\): start offset of .* should be a multiple of .*"), "alignment"},
      {of("(BUFFER_VIEW_TARGET_OVERRIDE|ACCESSOR_USAGE_OVERRIDE) .*"), "`target` of buffer views"},
      {of("(IMAGE_[A-Z_]*|INVALID_URI|IO_ERROR|VALUE_NOT_IN_LIST|UNSATISFIED_DEPENDENCY) /images/.*"),
       "content of images"},
      {of("TEXTURE_INVALID_IMAGE_MIME_TYPE .*"), "content of images"},
      {of("BUFFER_DATA_URI_MIME_TYPE_INVALID .*"), "media type of a data URI"},
      {of("MESH_PRIMITIVE_TOO_FEW_TEXCOORDS .*"), "textures on a primitive without coordinates"},
      {of("VALUE_NOT_IN_LIST /animations/.*/path"), "an unknown animation path"},
      {of(".*/extensions/(?!(KHR_lights_punctual|KHR_materials_unlit|KHR_texture_transform|KHR_materials_variants|"
          "KHR_materials_emissive_strength|KHR_animation_pointer)(/|$)).*"),
       "contents of extensions that are not read"},
  };
  return all;
}

// Refusals of files that the validator accepts, and where docs/gltf.md lists them.
const std::vector<std::pair<std::regex, std::string>>& refusedAllTheSame() {
  static const std::vector<std::pair<std::regex, std::string>> all = {
      {std::regex(".*requires .*, which is not supported"), "requires another extension"},
      {std::regex(".*'(yfov|xmag|ymag|aspectRatio|znear|zfar)' is .*, not .*"), "lenses"},
      {std::regex(".*needs .* of memory.*"), "memory"},
      {std::regex(".*extras.*'cuts'.*"), "`cuts`"},
      {std::regex(".*cannot be decoded.*|.*bytes are damaged.*"), "compressed streams"},
      {std::regex(".*cannot be read: No such file.*"), "backslash"},
  };
  return all;
}

bool isListed(const std::string& text, const std::vector<std::pair<std::regex, std::string>>& list) {
  return std::any_of(list.begin(), list.end(), [&](const auto& one) { return std::regex_match(text, one.first); });
}

struct Tally {
  size_t refused = 0, loaded = 0, listed = 0;
};

// Each error is refused in one line, or listed; a file without errors loads, or its refusal is listed.
Tally expectAgreement(const std::vector<Path>& files, const std::function<std::string(size_t)>& describe) {
  std::map<std::string, std::vector<std::string>> errors = errorsIn(files);
  Tally tally;
  for (size_t i = 0; i < files.size(); ++i) {
    const std::vector<std::string>& found = errors[files[i].string()];
    const std::string refusal = refusalOf(files[i]);
    const bool listed =
        std::all_of(found.begin(), found.end(), [](const auto& one) { return isListed(one, accepted()); });
    (!refusal.empty() ? tally.refused : found.empty() ? tally.loaded : tally.listed) += 1;
    const std::string what = describe(i) + "\n  validator: " + fmt::format("{}", fmt::join(found, ", "));
    EXPECT_TRUE(listed || !refusal.empty()) << what;
    const bool expected = refusal.empty() || !found.empty() || isListed(refusal, refusedAllTheSame());
    EXPECT_TRUE(expected) << what << "\n  here: " << refusal;
    EXPECT_EQ(refusal.find('\n'), std::string::npos) << what;
  }
  return tally;
}

TEST(GltfValidator, ExceptionsAreDocumented) {
  const std::string page = readText(sourceFolder() / "docs/gltf.md");
  for (const auto* list : {&accepted(), &refusedAllTheSame()})
    for (const auto& [what, phrase] : *list) EXPECT_NE(page.find(phrase), std::string::npos) << phrase;
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
  const Tally tally = expectAgreement(files, [](size_t i) {
    return i == 0 ? "whole" : fmt::format("{} = {}", changes()[i - 1].pointer, changes()[i - 1].value.dump());
  });
  EXPECT_EQ(refusalOf(files[0]), "");
  EXPECT_GE(tally.refused, changes().size() * 7 / 10);
  fs::remove_all(folder);
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

// Small files that scripts beside them write, each with one fault or oddity that programs have stumbled over.
TEST(GltfValidator, AgreesOnReportedFiles) {
  if (!hasValidator()) GTEST_SKIP() << "no node, or no gltf-validator in STROBE_NODE_MODULES";
  std::optional<Path> data = home().data();
  if (!data || !fs::is_directory(*data / "reports")) GTEST_SKIP() << "no shared reports (set STROBE_DATA)";
  const Path folder = fs::temp_directory_path() / fmt::format("strobe_reported_{}", ::getpid());
  for (const char* name : {"r06_upper_case", "r09_dropped_attributes", "r10_validator_errors", "r20_zero_weights",
                           "r24_compressed_optional", "r25_uris", "r48_skins", "r58_odd_files"}) {
    if (!fs::is_directory(*data / "reports" / name)) continue;
    fs::create_directories(folder);
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
  fs::remove_all(folder);
}

// --- seeded damage ------------------------------------------------------------------------------------------------

// The file with something of everything, and extensions, sparse accessors and more kinds of textures.
Json damageable() {
  Asset asset = everything();
  const int sparse_indices = asset.add<uint16_t>({1}, "SCALAR", 1, 5123);
  const int sparse_values = asset.add<float>({2, 0, 0}, "VEC3", 3, 5126);
  Json& json = asset.json;
  json["accessors"][0]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", json["accessors"][sparse_indices]["bufferView"]}, {"componentType", 5123}}},
      {"values", {{"bufferView", json["accessors"][sparse_values]["bufferView"]}}}};
  for (Json& accessor : json["accessors"]) accessor.erase("normalized");
  json["materials"].push_back(
      Json::parse(R"({"name":"glow","emissiveFactor":[1,0.5,0],"normalTexture":{"index":0,"scale":2},
      "occlusionTexture":{"index":0,"strength":0.5},"emissiveTexture":{"index":0},
      "extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":3}}})"));
  json["materials"].push_back(Json::parse(R"({"extensions":{"KHR_materials_unlit":{}}})"));
  asset.primitive()["extensions"]["KHR_materials_variants"]["mappings"] =
      Json::parse(R"([{"material":1,"variants":[0]},{"material":2,"variants":[1]}])");
  json["extensions"]["KHR_materials_variants"]["variants"] = Json::parse(R"([{"name":"a"},{"name":"b"}])");
  for (const char* name : {"KHR_materials_emissive_strength", "KHR_materials_unlit", "KHR_materials_variants"})
    json["extensionsUsed"].push_back(name);
  json["scenes"].push_back({{"name", "other"}, {"nodes", {2}}});
  return asset.whole();
}

// Pointers to all values in a file but the bytes of its buffers.
void listPointers(const Json& json, const std::string& at, std::vector<std::string>& pointers) {
  if (!at.empty() && !at.ends_with("/uri")) pointers.push_back(at);
  if (json.is_object())
    for (const auto& [name, value] : json.items()) listPointers(value, at + "/" + name, pointers);
  for (size_t i = 0; json.is_array() && i < json.size(); ++i)
    listPointers(json[i], fmt::format("{}/{}", at, i), pointers);
}

class Damager {
 public:
  explicit Damager(uint32_t seed) : state_(seed * 2654435761u + 1) {}

  // Changes, removes, swaps or doubles a value; returns what it did.
  std::string damage(Json& json) {
    std::vector<std::string> pointers;
    listPointers(json, "", pointers);
    const std::string at = pointers[random() % pointers.size()], other = pointers[random() % pointers.size()];
    const Json::json_pointer pointer(at), second(other);
    Json& holder = json.at(pointer.parent_pointer());
    Json& value = json.at(pointer);
    const uint32_t kind = random() % 8;
    if (kind == 0) {
      if (holder.is_array()) holder.erase(holder.begin() + std::stol(pointer.back()));
      else holder.erase(pointer.back());
      return at + " removed";
    }
    if (kind == 1 && value.is_array() && !value.empty()) {
      value.push_back(Json(value[random() % value.size()]));
      return at + " with a doubled element";
    }
    if (kind == 2 && !at.starts_with(other + "/") && !other.starts_with(at + "/")) {
      std::swap(value, json.at(second));
      return at + " and " + other + " swapped";
    }
    value = changed(value);
    return at + " = " + value.dump().substr(0, 60);
  }

 private:
  uint32_t random() { return state_ = state_ * 1664525u + 1013904223u, state_ >> 8; }

  Json changed(const Json& value) {
    const std::vector<Json> others = {
        -1, 0, 1, 2, 3, 0.5, 1e9, 4294967296.0, "x", "", true, Json::array(), Json::object()};
    if (value.is_number() && random() % 2 == 0) return value.get<double>() + (random() % 2 == 0 ? 1 : -1);
    if (value.is_number_integer() && random() % 3 == 0) return 5120 + random() % 7;
    return others[random() % others.size()];
  }

  uint32_t state_;
};

// STROBE_DAMAGED_FILES says how many.
TEST(GltfValidator, AgreesOnDamagedFiles) {
  if (!hasValidator()) GTEST_SKIP() << "no node, or no gltf-validator in STROBE_NODE_MODULES";
  const char* asked = std::getenv("STROBE_DAMAGED_FILES");
  const int count = asked ? std::atoi(asked) : 100;
  const Path folder = fs::temp_directory_path() / fmt::format("strobe_damaged_files_{}", ::getpid());
  const Json whole = damageable();
  std::vector<Path> files = {folder / "whole.gltf"};
  std::vector<std::string> what = {"whole"};
  writeQuickly(files[0], whole.dump());
  for (int seed = 0; seed < count; ++seed) {
    Json json = whole;
    Damager damager{uint32_t(seed)};
    what.push_back(fmt::format("seed {}: {}", seed, damager.damage(json)));
    if (seed % 3 == 2) what.back() += "; " + damager.damage(json);
    files.push_back(folder / fmt::format("{:05}.gltf", seed));
    writeQuickly(files.back(), json.dump());
  }
  const Tally tally = expectAgreement(files, [&](size_t i) { return what[i]; });
  EXPECT_EQ(refusalOf(files[0]), "");
  fmt::print("{} files refused, {} load without errors, {} with listed ones\n", tally.refused, tally.loaded,
             tally.listed);
  EXPECT_GE(tally.refused, size_t(count) / 3);
  EXPECT_GE(tally.loaded, size_t(count) / 20);
  fs::remove_all(folder);
}

}  // namespace gltf_validator_test
}  // namespace strobe::scene
