// SPDX-License-Identifier: MIT
// The form of whole files: declared extensions, unused objects, URIs, and memory implied by counts.
#include "common/refusal.h"
#include "scene/bend.h"
#include "scene/gltf_asset.h"
#include "scene/motion.h"

namespace strobe::scene {
namespace gltf_form_test {

void expectContains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text << "\n  lacks: " << part;
}

TEST_F(Gltf, UndeclaredExtensionsAreRefusedWithTheirPlace) {
  const std::pair<const char*, const char*> places[] = {
      {"/extensions/KHR_lights_punctual/lights", "a.gltf: extensions: KHR_lights_punctual"},
      {"/nodes/0/extensions/EXT_a", "nodes[0].extensions: EXT_a"},
      {"/scenes/0/extensions/EXT_a", "scenes[0].extensions: EXT_a"},
      {"/meshes/0/extensions/EXT_a", "meshes[0].extensions: EXT_a"},
      {"/meshes/0/primitives/0/extensions/EXT_a", "meshes[0].primitives[0].extensions: EXT_a"},
      {"/accessors/0/extensions/EXT_a", "accessors[0].extensions: EXT_a"},
      {"/buffers/0/extensions/EXT_a", "buffers[0].extensions: EXT_a"},
      {"/materials/0/extensions/KHR_materials_clearcoat", "materials[0].extensions: KHR_materials_clearcoat"},
      {"/materials/0/normalTexture/extensions/EXT_a", "materials[0].normalTexture.extensions: EXT_a"}};
  for (const auto& [pointer, said] : places) {
    Json json = triangle().whole();
    json["materials"] = Json::parse(R"([{"normalTexture":{"index":0}}])");
    json["textures"] = Json::parse("[{}]");
    json[Json::json_pointer(pointer)] = Json::object();
    if (std::string(pointer).ends_with("lights"))
      json["extensions"]["KHR_lights_punctual"]["lights"] = Json::parse(R"([{"type":"point"}])");
    expectContains(failure(json), said + std::string(" is not in extensionsUsed"));
    const std::string name = std::string(said).substr(std::string(said).rfind(' ') + 1);
    json["extensionsUsed"] = Json::array({name});
    EXPECT_EQ(failure(json), "") << pointer;
  }
}

TEST_F(Gltf, ExtensionsInAnotherPlaceAreRefused) {
  Json json = triangle().whole();
  json["nodes"][0]["extensions"]["KHR_materials_unlit"] = Json::object();
  json["extensionsUsed"] = {"KHR_materials_unlit"};
  expectContains(failure(json), "nodes[0].extensions: KHR_materials_unlit is not allowed here");
}

// Objects that the shown scene does not use are checked too.
TEST_F(Gltf, UnusedObjectsAreCheckedWithTheirPlace) {
  const std::tuple<const char*, Json, const char*> changes[] = {
      {"/samplers", Json::parse(R"([{"wrapS":1}])"), "samplers[0]: wrapS 1 is unknown"},
      {"/textures", Json::parse(R"([{"source":3}])"), "textures[0]: 'source' is 3, but the file has 0 images"},
      {"/images", Json::parse("[{}]"), "images[0]: has neither uri nor bufferView"},
      {"/images", Json::parse(R"([{"uri":"a.png","bufferView":0}])"), "images[0]: has both uri and bufferView"},
      {"/scenes/1", Json::parse(R"({"nodes":[0,0]})"), "scenes[1]: lists node 0 twice"},
      {"/scenes/1", Json::parse(R"({"nodes":[1]})"), "scenes[1]: 'nodes' is 1, but the file has 1 nodes"},
      {"/materials", Json::parse(R"([{"occlusionTexture":{"index":0,"strength":2}}])"),
       "materials[0].occlusionTexture: 'index' is 0"},
      {"/cameras", Json::parse(R"([{"type":"orthographic","orthographic":{"xmag":0,"ymag":1,"znear":0,"zfar":1}}])"),
       "cameras[0]: 'xmag' is 0"},
      {"/accessors/1", Json::parse(R"({"bufferView":0,"componentType":5126,"count":9,"type":"VEC3"})"),
       "accessors[1]: 9 elements do not fit in its buffer view of 36 bytes"},
      {"/accessors/1", Json::parse(R"({"bufferView":0,"componentType":5126,"count":1,"type":"VEC3","max":[1]})"),
       "accessors[1]: 'max' does not have 3 numbers"},
      {"/accessors/1",
       Json::parse(R"({"bufferView":0,"componentType":5126,"count":1,"type":"VEC3","normalized":true})"),
       "accessors[1]: componentType 5126 cannot be normalized"},
      {"/bufferViews/1", Json::parse(R"({"buffer":0,"byteLength":37})"),
       "bufferViews[1]: 37 bytes at byte 0 do not fit"},
      {"/nodes/0/name", 5, "nodes[0]: 'name' is not a text"},
      {"/meshes/0/primitives/0/attributes/FOO", 0, "meshes[0].primitives[0]: attribute 'FOO' is unknown"},
      {"/meshes/0/primitives/0/attributes/TEXCOORD_1", 0, "meshes[0].primitives[0]: TEXCOORD_1: accessors[0] is VEC3"}};
  for (const auto& [pointer, value, said] : changes) {
    Json json = triangle().whole();
    json[Json::json_pointer(pointer)] = value;
    expectContains(failure(json), said);
  }
  Json own = triangle().whole();
  own["meshes"][0]["primitives"][0]["attributes"]["_FOO"] = 0;
  own["accessors"][0]["count"] = 3.0;  // a whole number in JSON
  EXPECT_EQ(failure(own), "");
}

TEST_F(Gltf, KeysHaveTheFormatsOfTheirPath) {
  const std::tuple<const char*, const char*, Json, const char*> changes[] = {
      {"translation", "times", 5123, "input: accessors[1] is SCALAR of unsigned shorts, not SCALAR of floats"},
      {"rotation", "values", 5122, "rotation: accessors[2] is VEC4 of shorts, not VEC4 of floats"},
      {"translation", "values", 5122, "translation: accessors[2] is VEC3 of shorts, not VEC3 of floats"}};
  for (const auto& [path, what, type, said] : changes) {
    Asset asset = triangle();
    const int width = std::string(path) == "rotation" ? 4 : 3;
    const int times = asset.add<float>({0, 1}, "SCALAR", 1, 5126);
    std::vector<float> numbers(size_t(2 * width), 0.5f);
    const int values = asset.add<float>(numbers, width == 4 ? "VEC4" : "VEC3", width, 5126);
    asset.json["animations"] =
        Json::array({{{"samplers", Json::array({{{"input", times}, {"output", values}}})},
                      {"channels", Json::array({{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}})}}});
    EXPECT_EQ(failure(asset.whole()), "");
    asset.json["accessors"][std::string(what) == "times" ? times : values]["componentType"] = type;
    expectContains(failure(asset.whole()), said);
  }
}

TEST_F(Gltf, KeysBeforeTimeZeroAreRefused) {
  Asset asset = triangle();
  const int times = asset.add<float>({-1, 1}, "SCALAR", 1, 5126);
  const int values = asset.add<float>({0, 0, 0, 1, 0, 0}, "VEC3", 3, 5126);
  asset.json["animations"] =
      Json::array({{{"samplers", Json::array({{{"input", times}, {"output", values}}})},
                    {"channels", Json::array({{{"sampler", 0}, {"target", {{"node", 0}, {"path", "scale"}}}}})}}});
  expectContains(failure(asset.whole()), "animations[0].samplers[0]: its first key is at -1 s, below 0");
}

TEST_F(Gltf, TexturesWithoutCoordinatesAreWarnedOf) {
  Json json = triangle().whole();
  json["materials"] = Json::parse(R"([{"emissiveTexture":{"index":0}}])");
  json["textures"] = Json::parse("[{}]");
  json["meshes"][0]["primitives"][0]["material"] = 0;
  const Scene scene = load(json);
  ASSERT_FALSE(scene.warnings.empty());
  expectContains(scene.warnings[0], "emissiveTexture of materials[0] reads TEXCOORD_0, which is missing");
}

TEST_F(Gltf, IndicesThatRestartAreRefused) {
  Asset asset = triangle();
  asset.primitive()["indices"] = asset.add<uint8_t>({0, 1, 255}, "SCALAR", 1, 5121);
  expectContains(failure(asset.whole()), "index 2 is 255, the value for primitive restart");
}

// RFC 3986: a scheme ends at a colon before the first slash.
TEST_F(Gltf, ColonsAfterASlashBelongToNames) {
  Asset asset = triangle();
  Json json = asset.whole();
  const std::string bytes(asset.bytes.begin(), asset.bytes.end());
  for (const char* name : {"parts/a:1.bin", "parts/b:c/d.bin", "e1.bin"}) {
    writeQuickly(folder_ / name, bytes);
    json["buffers"][0]["uri"] = name;
    EXPECT_EQ(failure(json), "") << name;
  }
  for (const char* name : {"file:///a.bin", "http://a/b.bin", "c:/a.bin", "/a.bin"}) {
    json["buffers"][0]["uri"] = name;
    expectContains(failure(json), fmt::format("buffers[0]: '{}' is not a relative path", name));
  }
}

TEST_F(Gltf, ChunksOfGlbFilesAreChecked) {
  auto glb = [](const std::vector<std::pair<uint32_t, std::string>>& chunks) {
    std::string bytes;
    auto put = [&](uint32_t word) { bytes.append(reinterpret_cast<const char*>(&word), 4); };
    for (const auto& [kind, content] : chunks) put(uint32_t(content.size())), put(kind), bytes += content;
    std::string head = "glTF";
    std::swap(bytes, head);
    put(2), put(uint32_t(12 + head.size()));
    return bytes + head;
  };
  const uint32_t kJson = 0x4E4F534A, kBinary = 0x004E4942;
  const Asset asset = triangle();
  Json json = asset.json;
  json["buffers"] = Json::array({{{"byteLength", asset.bytes.size()}}});
  std::string text = json.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::string binary(asset.bytes.begin(), asset.bytes.end());
  auto loaded = [&](const std::string& bytes) {
    writeQuickly(folder_ / "A.GLB", bytes);
    return testing::refusalOf([&] { loadGltf(folder_ / "A.GLB"); });
  };
  EXPECT_EQ(loaded(glb({{kJson, text}, {kBinary, binary}})), "");
  EXPECT_EQ(loaded(glb({{kJson, text}, {kBinary, binary}, {1234, "abcd"}})), "");
  expectContains(loaded(glb({{kBinary, binary}, {kJson, text}})), "its first chunk is not JSON");
  expectContains(loaded(glb({{kJson, text}, {kBinary, binary}, {kBinary, binary}})),
                 "its binary chunk is chunk 2, not 1");
  expectContains(loaded(glb({{kJson, text}, {kJson, text}})), "has two JSON chunks");
  expectContains(loaded(glb({{kJson, text}, {kBinary, binary + "x"}})), "chunk 1 has 37 bytes, not a multiple of 4");
}

// --- memory -------------------------------------------------------------------------------------------------------

// Counts of elements without bytes in the file, in every place with a count: a few hundred bytes that would need
// gigabytes are refused, with numbers, before any allocation.
TEST_F(Gltf, CountsBeyondMemoryAreRefusedByTheirSum) {
  constexpr uint32_t kMany = 67000000;
  auto zeros = [](Asset& asset, const char* type, int component_type, uint64_t count) {
    asset.json["accessors"].push_back({{"componentType", component_type}, {"count", count}, {"type", type}});
    return int(asset.json["accessors"].size()) - 1;
  };
  const std::pair<const char*, std::function<void(Asset&)>> cases[] = {
      {"meshes[0].primitives[0]",
       [&](Asset& asset) { asset.primitive()["attributes"]["POSITION"] = zeros(asset, "VEC3", 5126, kMany); }},
      {"meshes[0].primitives[0]",
       [&](Asset& asset) { asset.primitive()["indices"] = zeros(asset, "SCALAR", 5125, kMany); }},
      {"meshes[0].primitives[0]",
       [&](Asset& asset) { asset.primitive()["indices"] = zeros(asset, "SCALAR", 5125, uint64_t(1) << 39); }},
      {"meshes[0].primitives[0]",
       [&](Asset& asset) {  // sparse: one element in the file
         const int accessor = zeros(asset, "VEC3", 5126, kMany);
         asset.add<uint32_t>({5}, "SCALAR", 1, 5125);
         asset.json["accessors"][size_t(accessor)]["sparse"] = {
             {"count", 1}, {"indices", {{"bufferView", 1}, {"componentType", 5125}}}, {"values", {{"bufferView", 0}}}};
         asset.primitive()["attributes"]["POSITION"] = accessor;
       }},
      {"meshes[0].primitives[0]",
       [&](Asset& asset) {  // few vertices, many targets
         asset.primitive()["attributes"]["POSITION"] = zeros(asset, "VEC3", 5126, 1000000);
         const int change = zeros(asset, "VEC3", 5126, 1000000);
         for (int i = 0; i < 100; ++i) asset.primitive()["targets"].push_back({{"POSITION", change}});
       }},
      {"meshes[0].primitives[",
       [&](Asset& asset) {  // one accessor, many primitives
         asset.primitive()["attributes"]["POSITION"] = zeros(asset, "VEC3", 5126, 1000000);
         const Json primitive = asset.primitive();
         for (int i = 0; i < 30; ++i) asset.json["meshes"][0]["primitives"].push_back(primitive);
       }},
      {"nodes[0]",
       [&](Asset& asset) {
         asset.json["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
         asset.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["SCALE"] =
             zeros(asset, "VEC3", 5126, kMany);
       }},
      {"skins[0]",
       [&](Asset& asset) {
         asset.json["skins"] =
             Json::array({{{"joints", {0}}, {"inverseBindMatrices", zeros(asset, "MAT4", 5126, kMany)}}});
       }},
      {"animations[0].channels[0]", [&](Asset& asset) {
         asset.json["animations"] = Json::array(
             {{{"samplers", Json::array({{{"input", zeros(asset, "SCALAR", 5126, kMany)},
                                          {"output", zeros(asset, "VEC3", 5126, kMany)}}})},
               {"channels", Json::array({{{"sampler", 0}, {"target", {{"node", 0}, {"path", "scale"}}}}})}}});
       }}};
  for (const auto& [place, change] : cases) {
    Asset asset = triangle();
    change(asset);
    const std::string text = failure(asset.whole());
    expectContains(text, place);
    expectContains(text, "GiB of memory; the whole file needs ");
    expectContains(text, "more than the 1.0 GiB allowed for a file of its size");
  }
  Asset asset = triangle();  // zero-filled and small
  asset.primitive()["attributes"]["NORMAL"] = zeros(asset, "VEC3", 5126, 3);
  EXPECT_EQ(failure(asset.whole()), "");
}

// --- skins --------------------------------------------------------------------------------------------------------

// Two primitives: the first follows a joint, the second follows the node and has no weights in the file.
TEST_F(Gltf, PrimitivesWithoutJointsFollowTheNode) {
  Asset asset = triangle();
  asset.json["nodes"] =
      Json::parse(R"([{"name":"shown","mesh":0,"skin":0,"translation":[0,0,5]},{"translation":[0,3,0]},{}])");
  asset.json["scenes"][0]["nodes"] = {0, 1, 2};
  asset.json["skins"] = Json::parse(R"([{"joints":[1,2]}])");
  const Json plain = asset.primitive();
  asset.primitive()["attributes"]["JOINTS_0"] = asset.add<uint8_t>(std::vector<uint8_t>(12), "VEC4", 4, 5121);
  asset.primitive()["attributes"]["WEIGHTS_0"] =
      asset.add<float>({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4", 4, 5126);
  asset.json["meshes"][0]["primitives"].push_back(plain);
  Scene scene = load(asset.whole());
  scene.motions.push_back({.node = 0, .velocity = {1, 0, 0}});
  for (double time_s : {0.0, 2.0}) {
    const std::vector<Instance> instances = instancesOf(scene);
    const Pose pose = Poser(scene, -1).at(time_s);
    std::vector<dvec3> corners;
    for (const BentVertex& vertex : bentVertices(scene, instances.at(0), pose.bends.at(0)))
      corners.push_back(dvec3(pose.world_from_instance.at(0) * dvec4(vertex.position, 1)));
    const dvec3 moved(time_s, 0, 0);  // motion of the node, applied once
    const dvec3 expected[] = {{0, 3, 0}, {2, 3, 0}, {0, 5, 0}, {0, 0, 5}, {2, 0, 5}, {0, 2, 5}};
    ASSERT_EQ(corners.size(), 6u);
    for (size_t i = 0; i < 6; ++i) EXPECT_LE(glm::distance(corners[i], expected[i] + moved), 1e-6) << i;
  }
  asset.json["meshes"][0]["primitives"].erase(0);
  expectContains(failure(asset.whole()), "nodes[0]: has a skin, but meshes[0] has no joints");
}

}  // namespace gltf_form_test
}  // namespace strobe::scene
