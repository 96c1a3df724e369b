// SPDX-License-Identifier: MIT
// glTF files at nodes of a scene described in Lua, and images as textures.
#include <cmath>

#include "common/refusal.h"
#include "scene/gltf_asset.h"
#include "scene/json_scene.h"
#include "scene/motion.h"

namespace strobe::scene {
namespace attach_test {

// 2 x 1 texels, (255, 0, 0) and (0, 128, 255).
const std::vector<uint8_t> kPng = {137, 80,  78,  71, 13, 10,  26,  10, 0,   0,   0,   13,  73,  72,  68,  82, 0,  0,
                                   0,   2,   0,   0,  0,  1,   8,   2,  0,   0,   0,   123, 64,  232, 221, 0,  0,  0,
                                   15,  73,  68,  65, 84, 120, 156, 99, 248, 207, 192, 192, 208, 240, 31,  0,  8,  0,
                                   2,   127, 156, 69, 64, 78,  0,   0,  0,   0,   73,  69,  78,  68,  174, 66, 96, 130};

class Attached : public Gltf {
 protected:
  void SetUp() override {
    writeQuickly(folder_ / "textures/two.png", {reinterpret_cast<const char*>(kPng.data()), kPng.size()});
  }
  // A triangle "blade" under "hub", which clip "spin" moves by x = 1 in a second; a camera and a light.
  static Json fan() {
    Asset asset = triangle();
    asset.json["nodes"] = Json::parse(R"([{"name":"blade","mesh":0},{"name":"hub","children":[0]},
        {"name":"view","camera":0},{"name":"lamp","extensions":{"KHR_lights_punctual":{"light":0}}}])");
    asset.json["scenes"][0]["nodes"] = {1, 2, 3};
    asset.json["cameras"] = Json::parse(R"([{"type":"perspective","perspective":{"yfov":1,"znear":0.1}}])");
    asset.json["extensionsUsed"] = {"KHR_lights_punctual", "KHR_other"};
    asset.json["extensions"]["KHR_lights_punctual"]["lights"] = Json::parse(R"([{"type":"point","name":"bulb"}])");
    asset.json["asset"]["copyright"] = "CC0 someone";
    asset.json["materials"] =
        Json::parse(R"([{"name":"paint","pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}])");
    asset.json["textures"] = Json::parse(R"([{"source":0}])");
    asset.json["images"] = Json::parse(R"([{"uri":"two.png"}])");
    asset.primitive()["material"] = 0;
    asset.primitive()["attributes"]["TEXCOORD_0"] = asset.add<float>({0, 0, 1, 0, 0, 1}, "VEC2", 2, 5126);
    const int times = asset.add<float>({0, 1}, "SCALAR", 1, 5126);
    asset.json["animations"] = Json::array();
    for (const char* name : {"spin", "shake"}) {
      const int places = asset.add<float>({0, 0, 0, name[1] == 'p' ? 1.f : 0.f, 1, 0}, "VEC3", 3, 5126);
      asset.json["animations"].push_back(
          {{"name", name},
           {"samplers", Json::array({{{"input", times}, {"output", places}}})},
           {"channels", Json::array({{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}})}});
    }
    return asset.whole();
  }
  // A scene of these nodes, in the form of the Lua constructors, with a camera "eye" at the end.
  Scene build(const std::string& nodes, const std::string& more = "") {
    writeQuickly(folder_ / "textures/fan.gltf", fan().dump());
    return sceneFromJson(Json::parse(R"({"kind":"scene","nodes":[)" + nodes +
                                     R"(,{"kind":"node","name":"eye","camera":{"kind":"camera"}}])" + more + "}"),
                         folder_ / "test.lua");
  }
  std::string mistake(const std::string& nodes, const std::string& more = "") {
    return testing::refusalOf([&] { build(nodes, more); });
  }
  static std::string at(const std::string& name, const std::string& more = "",
                        const std::string& file = "textures/fan.gltf") {
    return R"({"kind":"node","name":")" + name + R"(","position":[10,0,0],"scale":2,"gltf":{"kind":"gltf","file":")" +
           file + "\"" + more + "}}";
  }
  static dvec3 placeOf(const Scene& scene, const std::string& name, double time_s) {
    return dvec3(Poser(scene, -1).nodesAt(time_s, time_s).at(size_t(nodeByName(scene, name)))[3]);
  }
};

TEST_F(Attached, FileIsAtItsNodeWithItsNames) {
  const Scene scene = build(at("fan"));
  EXPECT_EQ(placeOf(scene, "fan", 0), dvec3(10, 0, 0));
  EXPECT_EQ(placeOf(scene, "fan/blade", 0.5), dvec3(11, 1, 0));  // half of (1, 1), at twice the size
  EXPECT_EQ(instancesOf(scene).size(), 1u);
  EXPECT_EQ(scene.animations.at(0).name, "fan/spin");
  EXPECT_EQ(scene.lights.at(0).name, "fan/bulb");
  EXPECT_EQ(cameraNode(scene, ""), nodeByName(scene, "eye")) << "the scene's camera comes first";
  EXPECT_EQ(cameraNode(scene, "fan/view"), nodeByName(scene, "fan/view"));
  EXPECT_EQ(scene.warnings, std::vector<std::string>{"fan: extension KHR_other is ignored"});
  EXPECT_EQ(scene.attribution["copyright"], "CC0 someone");
  const Material& paint = scene.materials.at(size_t(scene.meshes.at(0).geometries.at(0).material));
  EXPECT_EQ(paint.name, "paint");
  EXPECT_EQ(scene.textures.at(size_t(paint.base_color_texture.texture)).width, 2);
  std::vector<Path> files;
  for (const SourceFile& file : scene.files) files.push_back(file.path.filename());
  EXPECT_EQ(files, (std::vector<Path>{"fan.gltf", "two.png"}));
}

TEST_F(Attached, EqualFilesAreLoadedOnce) {
  const Scene one = build(at("a")), two = build(at("a") + "," + at("b"));
  EXPECT_EQ(two.meshes.size(), one.meshes.size());
  EXPECT_EQ(two.textures.size(), one.textures.size());
  EXPECT_EQ(instancesOf(two).size(), 2u);
  EXPECT_EQ(placeOf(two, "b/blade", 0.5), dvec3(11, 1, 0));
}

TEST_F(Attached, ClipsAreChosen) {
  EXPECT_EQ(build(at("fan", R"(,"animation":"none")")).animations.size(), 0u);
  const Scene shaken = build(at("fan", R"(,"animation":"shake")"));
  ASSERT_EQ(shaken.animations.size(), 1u);
  EXPECT_EQ(placeOf(shaken, "fan/hub", 1), dvec3(10, 2, 0));
  const Scene all = build(at("fan"));
  EXPECT_EQ(all.animations.at(1).yields_to, 0) << "the first of several clips of one target plays";
}

TEST_F(Attached, TracksOfTheSceneDriveItsNodes) {
  const Scene scene = build(at("fan", R"(,"animation":"none")"),
                            R"(,"animations":[{"kind":"animation","name":"lift","tracks":[{"kind":"track",
                              "node":"fan/blade","times":[0,1],"values":[[0,0,0],[0,0,3]]}]}])");
  EXPECT_EQ(placeOf(scene, "fan/blade", 1), dvec3(10, 0, 6));
}

TEST_F(Attached, MistakesNameThePlaceAndTheFile) {
  auto expect = [](const std::string& text, const std::string& what) {
    EXPECT_NE(text.find(what), std::string::npos) << text;
  };
  expect(mistake(at("fan", "", "no.glb")), "gltf: 'no.glb' is not a file in the scene's folder");
  expect(mistake(at("fan", "", "textures/two.png")), "two.png");
  expect(mistake(at("fan", R"(,"animation":"spn")")), "did you mean 'spin'?");
  expect(mistake(at("fan", R"(,"variant":"red")")), "has no material variants");
  expect(mistake(at("fan", R"(,"colour":1)")), "gltf: unknown key 'colour'");
  expect(mistake(at("fan") + R"(,{"kind":"node","name":"fan/hub"})"), "another node is called 'fan/hub'");
  expect(mistake(R"({"kind":"node","name":"a","gltf":"textures/fan.gltf"})"), "write scene.gltf { ... }");
}

TEST_F(Attached, FilesMustBeInTheFolderUnlessAllowed) {
  const Json scene = Json::parse(R"({"kind":"scene","nodes":[)" + at("fan", "", "../textures/fan.gltf") + "]}");
  build(at("fan"));
  std::filesystem::create_directories(folder_ / "scenes");
  auto failureIn = [&](const FilePlaces& places) -> std::string {
    return testing::refusalOf([&] { sceneFromJson(scene, "test.lua", {}, paintPattern, places); });
  };
  EXPECT_NE(failureIn({folder_ / "scenes"}).find("is outside of the scene's folder; use --allow-outside"),
            std::string::npos);
  EXPECT_EQ(failureIn({folder_ / "scenes", folder_}), "");
  EXPECT_EQ(failureIn({folder_ / "scenes", {}, true}), "");
}

TEST_F(Attached, ImagesAreTextures) {
  auto quad = [](const std::string& file, const std::string& use) {
    return R"({"kind":"node","name":"q","shape":{"kind":"shape","type":"quad"},"material":{"kind":"material",")" + use +
           R"(":{"kind":"texture","type":"image","wrap":"clamp","file":")" + file + "\"}}}";
  };
  const Texture color = build(quad("textures/two.png", "color_texture")).textures.at(0);
  EXPECT_EQ(color.levels.at(0), (std::vector<uint8_t>{255, 0, 0, 255, 0, 128, 255, 255}));
  EXPECT_EQ(color.format, Texture::Format::Rgba8Srgb);
  EXPECT_EQ(color.wrap_u, Texture::Wrap::Clamp);
  ASSERT_EQ(color.levels.size(), 2u);
  // The mean of 0 and 255 in linear light is sRGB 188; the mean of the numbers is 128.
  EXPECT_EQ(color.levels[1][0], 188);
  const Texture numbers = build(quad("textures/two.png", "normal_texture")).textures.at(0);
  EXPECT_EQ(numbers.format, Texture::Format::Rgba8Unorm);
  EXPECT_EQ(numbers.levels.at(1)[0], 128);
  writeQuickly(folder_ / "bad.png", "no image");
  EXPECT_NE(mistake(quad("bad.png", "color_texture")).find("texture image: 'bad.png' is not a readable PNG or JPEG"),
            std::string::npos);
  EXPECT_NE(mistake(quad("none.png", "color_texture")).find("'none.png' is not a file"), std::string::npos);
  EXPECT_NE(mistake(quad("/none.png", "color_texture")).find("is not a relative path"), std::string::npos);
}

}  // namespace attach_test
}  // namespace strobe::scene
