// SPDX-License-Identifier: MIT
// Attributes of meshes and morph targets: used, unused with a warning, or refused.
#include "scene/gltf_asset.h"

namespace strobe::scene {
namespace gltf_attributes_test {

using GltfAttributes = Gltf;

// A triangle with normals and a normal map.
Asset bumped() {
  Asset asset = triangle();
  asset.primitive()["attributes"]["NORMAL"] = asset.add<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 3, 5126);
  asset.primitive()["attributes"]["TEXCOORD_0"] = asset.add<float>({0, 0, 1, 0, 0, 1}, "VEC2", 2, 5126);
  asset.json["images"] = Json::parse(
      R"([{"uri":"data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR42mO41XALAARsAjUuHifuAAAAAElFTkSuQmCC"}])");
  asset.json["textures"] = Json::parse(R"([{"source":0}])");
  asset.json["materials"] = Json::parse(R"([{"normalTexture":{"index":0}}])");
  asset.primitive()["material"] = 0;
  return asset;
}

int tangents(Asset& asset, const std::vector<float>& one) {
  std::vector<float> all;
  for (int i = 0; i < 3; ++i) all.insert(all.end(), one.begin(), one.end());
  return asset.add(all, "VEC4", 4, 5126);
}

const Geometry& geometryOf(const Scene& scene) { return scene.meshes.at(0).geometries.at(0); }

TEST_F(GltfAttributes, TangentsMatchTheFile) {
  Asset asset = bumped();
  asset.primitive()["attributes"]["TANGENT"] = tangents(asset, {0, 3, 4, -1});
  asset.primitive()["targets"] =
      Json::array({{{"TANGENT", asset.add<float>({1, 0, 0, 2, 0, 0, 3, 0, 0}, "VEC3", 3, 5126)}}});
  const Scene scene = load(asset.whole());
  ASSERT_EQ(geometryOf(scene).tangents.size(), 3u);
  EXPECT_EQ(geometryOf(scene).tangents[1], vec4(0, .6f, .8f, -1));
  EXPECT_EQ(geometryOf(scene).targets.at(0).tangents.at(2), vec3(3, 0, 0));
  EXPECT_TRUE(scene.warnings.empty());
}

// glTF 2.0, 3.7.2.1: tangents without normals are ignored. Without a normal map no shader reads them.
TEST_F(GltfAttributes, UnusedTangentsAreDropped) {
  for (const char* lacking : {"normals", "map"}) {
    Asset asset = bumped();
    asset.primitive()["attributes"]["TANGENT"] = tangents(asset, {1, 0, 0, 1});
    if (std::string(lacking) == "map") asset.json["materials"][0].erase("normalTexture");
    else asset.primitive()["attributes"].erase("NORMAL");
    const Scene scene = load(asset.whole());
    EXPECT_TRUE(geometryOf(scene).tangents.empty()) << lacking;
    EXPECT_TRUE(scene.warnings.empty()) << lacking;
  }
}

TEST_F(GltfAttributes, UnsoundTangentsAreRefusedOrNamed) {
  Asset asset = bumped();
  asset.primitive()["attributes"]["TANGENT"] = tangents(asset, {1, 0, 0, .5f});
  EXPECT_NE(failure(asset.whole()).find("meshes[0].primitives[0]: TANGENT 0 has a w of 0.5, not 1 or -1"),
            std::string::npos)
      << failure(asset.whole());
  asset = bumped();
  asset.primitive()["attributes"]["TANGENT"] = tangents(asset, {0, 0, 0, 1});
  const Scene scene = load(asset.whole());
  EXPECT_EQ(geometryOf(scene).tangents.at(0), vec4(0));
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_NE(scene.warnings[0].find("3 vertices have tangents that are 0 or not finite"), std::string::npos)
      << scene.warnings[0];
}

TEST_F(GltfAttributes, UnusedAttributesAreNamedInOneWarning) {
  Asset asset = triangle();
  const int colors = asset.add(std::vector<float>(12, 1), "VEC4", 4, 5126),
            uvs = asset.add(std::vector<float>(6, 0), "VEC2", 2, 5126);
  Json& attributes = asset.primitive()["attributes"];
  attributes.update({{"COLOR_0", colors}, {"COLOR_1", colors}, {"_OWN", colors}});
  for (const char* set : {"TEXCOORD_0", "TEXCOORD_1", "TEXCOORD_2", "TEXCOORD_3"}) attributes[set] = uvs;
  EXPECT_EQ(load(asset.whole()).warnings,
            std::vector<std::string>{"attributes are not used: COLOR_1 (1 primitive), TEXCOORD_2 (1 primitive), "
                                     "TEXCOORD_3 (1 primitive)"});

  asset = triangle();
  asset.primitive()["attributes"]["COLOR_0"] = asset.add(std::vector<float>(12, 1), "VEC4", 4, 5126);
  asset.primitive()["targets"] = Json::array({{{"COLOR_0", asset.add(std::vector<float>(12, -1), "VEC4", 4, 5126)}}});
  asset.json["meshes"].push_back(asset.json["meshes"][0]);
  EXPECT_EQ(load(asset.whole()).warnings,
            std::vector<std::string>{"attributes are not used: COLOR_0 of morph targets (2 primitives)"});
}

// The validator's errors MESH_PRIMITIVE_INVALID_ATTRIBUTE and MESH_PRIMITIVE_INDEXED_SEMANTIC_CONTINUITY.
TEST_F(GltfAttributes, UnknownNamesAreRefused) {
  for (const char* name :
       {"FOO", "TEXCOORD", "TEXCOORD_", "TEXCOORD_X", "COLOR_0_0", "COLOR_00", "NORMAL_0", "position", ""}) {
    Asset asset = triangle();
    asset.primitive()["attributes"][name] = 0;
    EXPECT_NE(failure(asset.whole()).find(fmt::format("primitives[0]: attribute '{}' is unknown", name)),
              std::string::npos)
        << name;
  }
  Asset asset = triangle();
  asset.primitive()["attributes"]["TEXCOORD_1"] = asset.add(std::vector<float>(6, 0), "VEC2", 2, 5126);
  EXPECT_NE(failure(asset.whole()).find("TEXCOORD_0 is missing"), std::string::npos);
  for (const char* name : {"JOINTS_0", "WEIGHTS_0", "FOO", "NORMAL_0", "TEXCOORD", "position"}) {
    asset = triangle();
    asset.primitive()["targets"] = Json::array({{{"POSITION", 0}}, {{name, 0}}});
    const std::string refusal = failure(asset.whole());
    const std::string wanted = fmt::format(": meshes[0].primitives[0].targets[1]: attribute '{}' is unknown", name);
    EXPECT_TRUE(refusal.ends_with(wanted)) << refusal;
  }
}

TEST_F(GltfAttributes, AttributesOfLinesAreChecked) {
  Asset asset = triangle();
  asset.primitive()["mode"] = 1;
  asset.primitive()["attributes"]["JOINTS_0"] = asset.add<uint8_t>(std::vector<uint8_t>(12), "VEC4", 4, 5121);
  EXPECT_TRUE(failure(asset.whole()).ends_with(": meshes[0].primitives[0]: WEIGHTS_0 is missing"));
  asset.primitive()["attributes"].erase("JOINTS_0");
  asset.primitive()["attributes"]["TANGENT"] = tangents(asset, {1, 0, 0, .5f});
  EXPECT_TRUE(failure(asset.whole()).ends_with("TANGENT 0 has a w of 0.5, not 1 or -1"));
}

}  // namespace gltf_attributes_test
}  // namespace strobe::scene
