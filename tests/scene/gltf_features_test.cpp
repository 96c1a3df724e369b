// SPDX-License-Identifier: MIT
// Materials, samplers, instances and animations of a file, each compared with its specification.
#include <cmath>

#include "scene/defaults.h"
#include "scene/frame_poser.h"
#include "scene/gltf_asset.h"
#include "scene/motion.h"

namespace strobe::scene {
namespace gltf_features_test {

using Filter = Texture::Filter;
using Levels = Texture::Levels;
using Wrap = Texture::Wrap;

// One white texel as PNG.
const char* const kPixel =
    "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8/5+hHgAHggJ/"
    "PchI7wAAAABJRU5ErkJggg==";

// A triangle whose material has a texture with this sampler.
Json textured(const Json& sampler) {
  Asset asset = triangle();
  asset.add<float>({0, 0, 1, 0, 0, 1}, "VEC2", 2, 5126);
  asset.primitive()["attributes"]["TEXCOORD_0"] = 1;
  asset.primitive()["material"] = 0;
  asset.json["images"] = Json::array({{{"uri", kPixel}}});
  asset.json["textures"] = Json::array({{{"source", 0}, {"sampler", 0}}});
  asset.json["samplers"] = Json::array({sampler});
  asset.json["materials"] = Json::array({{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}});
  return asset.whole();
}

TEST_F(Gltf, SamplersMatchTheFile) {
  struct Case {
    Json sampler;
    Filter magnify, minify;
    Levels between;
    Wrap u, v;
  };
  const Case cases[] = {
      {Json::object(), Filter::Linear, Filter::Linear, Levels::Linear, Wrap::Repeat, Wrap::Repeat},
      {{{"magFilter", 9728}}, Filter::Nearest, Filter::Linear, Levels::Linear, Wrap::Repeat, Wrap::Repeat},
      {{{"minFilter", 9728}, {"wrapS", 33071}},
       Filter::Linear,
       Filter::Nearest,
       Levels::None,
       Wrap::Clamp,
       Wrap::Repeat},
      {{{"minFilter", 9729}, {"wrapT", 33648}},
       Filter::Linear,
       Filter::Linear,
       Levels::None,
       Wrap::Repeat,
       Wrap::Mirror},
      {{{"minFilter", 9984}}, Filter::Linear, Filter::Nearest, Levels::Nearest, Wrap::Repeat, Wrap::Repeat},
      {{{"minFilter", 9985}}, Filter::Linear, Filter::Linear, Levels::Nearest, Wrap::Repeat, Wrap::Repeat},
      {{{"minFilter", 9986}}, Filter::Linear, Filter::Nearest, Levels::Linear, Wrap::Repeat, Wrap::Repeat},
      {{{"minFilter", 9987}, {"magFilter", 9729}},
       Filter::Linear,
       Filter::Linear,
       Levels::Linear,
       Wrap::Repeat,
       Wrap::Repeat},
  };
  for (const Case& one : cases) {
    Scene scene = load(textured(one.sampler));
    ASSERT_EQ(scene.textures.size(), 1u);
    const Texture& texture = scene.textures[0];
    EXPECT_EQ(texture.magnify, one.magnify) << one.sampler;
    EXPECT_EQ(texture.minify, one.minify) << one.sampler;
    EXPECT_EQ(texture.between, one.between) << one.sampler;
    EXPECT_EQ(texture.wrap_u, one.u) << one.sampler;
    EXPECT_EQ(texture.wrap_v, one.v) << one.sampler;
  }
  for (const char* key : {"magFilter", "minFilter", "wrapS", "wrapT"})
    EXPECT_NE(failure(textured({{key, 9990}})).find(fmt::format("samplers[0]: {} 9990", key)), std::string::npos);
}

// An image with two different samplers becomes two textures, with two equal samplers one texture.
TEST_F(Gltf, ImagesAreSharedByEqualSamplers) {
  Json json = textured({{"magFilter", 9728}});
  json["samplers"].push_back(Json::object());
  json["textures"].push_back({{"source", 0}, {"sampler", 1}});
  json["textures"].push_back({{"source", 0}});
  for (int texture : {1, 2})
    json["materials"].push_back({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}});
  Scene scene = load(json);
  ASSERT_EQ(scene.textures.size(), 2u);
  EXPECT_EQ(scene.materials[1].base_color_texture.texture, scene.materials[2].base_color_texture.texture);
  EXPECT_EQ(scene.textures[0].magnify, Filter::Nearest);
}

TEST_F(Gltf, MaterialsAreSingleSidedByDefault) {
  Json json = textured(Json::object());
  json["materials"].push_back({{"doubleSided", true}, {"alphaMode", "BLEND"}});
  json["materials"].push_back({{"alphaMode", "MASK"}, {"alphaCutoff", 0.25}});
  Scene scene = load(json);
  EXPECT_FALSE(scene.materials[0].double_sided);
  EXPECT_TRUE(scene.materials[1].double_sided);
  EXPECT_FALSE(scene.materials.back().double_sided) << "default material of a primitive without one";
  EXPECT_EQ(scene.materials[0].alpha, Material::Alpha::Opaque);
  EXPECT_EQ(scene.materials[1].alpha, Material::Alpha::Blend);
  EXPECT_EQ(scene.materials[2].alpha, Material::Alpha::Mask);
  EXPECT_EQ(scene.materials[2].alpha_cutoff, 0.25f);
  EXPECT_TRUE(scene.warnings.empty());
}

// Matrices of KHR_texture_transform: translation * rotation * scale; texCoord replaces the texture's own.
TEST_F(Gltf, TexturesAreTransformed) {
  Json json = textured(Json::object());
  Json& info = json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
  info["extensions"]["KHR_texture_transform"] = {
      {"offset", {0.5, 0.25}}, {"rotation", 0.3}, {"scale", {2, 3}}, {"texCoord", 1}};
  declareExtensions(json);
  Scene scene = load(json);
  const TextureUse& use = scene.materials[0].base_color_texture;
  EXPECT_EQ(use.uv_set, 1);
  double u = 0.7, v = -0.2, c = std::cos(0.3), s = std::sin(0.3);
  dvec2 moved = use.uv_transform * dvec3(u, v, 1);
  EXPECT_NEAR(moved.x, c * 2 * u + s * 3 * v + 0.5, 1e-12);
  EXPECT_NEAR(moved.y, -s * 2 * u + c * 3 * v + 0.25, 1e-12);
}

// ---- Variants

Json withVariants() {
  Asset asset = triangle();
  asset.json["materials"] = Json::array({{{"name", "plain"}}, {{"name", "red"}}, {{"name", "blue"}}});
  asset.json["extensions"]["KHR_materials_variants"]["variants"] =
      Json::array({{{"name", "summer"}}, {{"name", "winter"}}, {{"name", "night"}}});
  asset.primitive()["material"] = 0;
  asset.primitive()["extensions"]["KHR_materials_variants"]["mappings"] =
      Json::array({{{"material", 1}, {"variants", {0}}}, {{"material", 2}, {"variants", {1}}}});
  return asset.whole();
}

TEST_F(Gltf, VariantsChooseMaterials) {
  const std::pair<const char*, int> choices[] = {{"", 0}, {"summer", 1}, {"winter", 2}, {"night", 0}};
  for (auto [variant, material] : choices) {
    Scene scene = load(withVariants(), {.variant = variant});
    EXPECT_EQ(scene.meshes[0].geometries[0].material, material) << variant;
  }
  std::string text = failure(withVariants(), {.variant = "sumer"});
  EXPECT_NE(text.find("did you mean 'summer'?; it has summer, winter, night"), std::string::npos) << text;
  EXPECT_NE(failure(triangle().whole(), {.variant = "summer"}).find("has no material variants"), std::string::npos);
}

// ---- Instances

TEST_F(Gltf, InstanceRotationsMayBeIntegers) {
  Asset asset = triangle();
  int moves = asset.add<float>({1, 0, 0, 0, 5, 0}, "VEC3", 3, 5126);
  int turns = asset.add<int16_t>({0, 0, 23170, 23170, 0, 0, 0, 32767}, "VEC4", 4, 5122, true);
  int sizes = asset.add<float>({2, 2, 2, 1, 1, 1}, "VEC3", 3, 5126);
  asset.json["nodes"][0]["translation"] = {0, 0, 7};
  asset.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
      {"TRANSLATION", moves}, {"ROTATION", turns}, {"SCALE", sizes}};
  Scene scene = load(asset.whole());
  Pose pose = Poser(scene, -1).at(0);
  ASSERT_EQ(pose.world_from_instance.size(), 2u);
  dvec4 corner = pose.world_from_instance[0] * dvec4(dvec3(2, 0, 0) - scene.meshes[0].origin, 1);
  EXPECT_NEAR(corner.x, 1, 1e-6);  // scaled by 2, rotated 90 degrees about z, moved by 1
  EXPECT_NEAR(corner.y, 4, 1e-6);
  EXPECT_NEAR(corner.z, 7, 1e-6);
  asset.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["SCALE"] = 0;
  EXPECT_NE(failure(asset.whole()).find("have different counts"), std::string::npos);
}

// ---- Animated lenses and lights

// A perspective and an orthographic camera, a spot light, and an animation with one channel.
struct Pointed {
  Asset asset = triangle();
  int times;

  Pointed() {
    asset.json["nodes"] = Json::parse(R"([{"mesh":0},{"camera":0},{"camera":1},
        {"extensions":{"KHR_lights_punctual":{"light":0}}}])");
    asset.json["scenes"][0]["nodes"] = {0, 1, 2, 3};
    asset.json["cameras"] = Json::parse(R"([{"type":"perspective","name":"p","perspective":{"yfov":1,"znear":0.1}},
        {"type":"orthographic","name":"o","orthographic":{"xmag":1,"ymag":1,"znear":0.1,"zfar":9}}])");
    asset.json["extensions"]["KHR_lights_punctual"]["lights"] = Json::parse(
        R"([{"type":"spot","intensity":3,"color":[1,0.5,0.25],"spot":{"innerConeAngle":0.1,"outerConeAngle":0.4}}])");
    times = asset.add<float>({0, 2}, "SCALAR", 1, 5126);
  }
  Json moving(const std::string& pointer, const std::vector<float>& values, const char* how = "LINEAR") {
    const char* types[] = {"", "SCALAR", "", "VEC3", "VEC4"};
    int width = int(values.size()) / 2;
    int output = asset.add<float>(values, types[width], width, 5126);
    Json target = {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", pointer}}}}}};
    asset.json["animations"] =
        Json::array({{{"samplers", Json::array({{{"input", times}, {"output", output}, {"interpolation", how}}})},
                      {"channels", Json::array({{{"sampler", 0}, {"target", target}}})}}});
    asset.json["extensionsUsed"] = asset.json["extensionsRequired"] = {"KHR_animation_pointer"};
    return asset.whole();
  }
};

TEST_F(Gltf, PointersMoveNodesLensesAndLights) {
  auto at = [&](const std::string& camera, const std::string& pointer, const std::vector<float>& values,
                double time_s) {
    Scene scene = load(Pointed().moving(pointer, values));
    EXPECT_TRUE(scene.warnings.empty()) << pointer;
    return Poser(scene, cameraNode(scene, camera)).at(time_s);
  };
  EXPECT_NEAR(at("p", "/nodes/0/translation", {0, 0, 0, 4, 0, 0}, 0.5).world_from_instance[0][3].x, 1 + 1, 1e-9)
      << "with the mesh's centre at x = 1";
  EXPECT_NEAR(at("p", "/cameras/0/perspective/yfov", {1, 0.5}, 1).camera.vertical_fov, 0.75, 1e-7);
  EXPECT_NEAR(at("p", "/cameras/0/perspective/znear", {0.1f, 0.3f}, 1).camera.near, 0.2, 1e-7);
  EXPECT_NEAR(at("o", "/cameras/1/orthographic/ymag", {1, 3}, 1.5).camera.half_height, 2.5, 1e-7);
  EXPECT_NEAR(at("o", "/cameras/0/perspective/yfov", {1, 0.5}, 1).camera.vertical_fov, Camera().vertical_fov, 0)
      << "the orthographic camera";
  const std::string light = "/extensions/KHR_lights_punctual/lights/0";
  Pose dark = at("p", light + "/intensity", {3, 0}, 1);
  EXPECT_NEAR(dark.lights.at(0).emitted().y / dark.lights[0].moderation, 1.5 * 0.5, 1e-6);
  EXPECT_EQ(at("p", light + "/color", {1, 1, 1, 0, 1, 0.5}, 1).lights.at(0).color, vec3(0.5f, 1, 0.75f));
  EXPECT_NEAR(at("p", light + "/range", {2, 6}, 1).lights.at(0).range, 4, 1e-6);
  EXPECT_NEAR(at("p", light + "/spot/outerConeAngle", {0.2f, 0.4f}, 1).lights.at(0).outer_cone, 0.3, 1e-6);
  EXPECT_NEAR(at("p", light + "/spot/innerConeAngle", {0, 0.1f}, 1).lights.at(0).inner_cone, 0.05, 1e-6);
}

TEST_F(Gltf, SteppedLensesAreStaticWithinAFrame) {
  Scene scene = load(Pointed().moving("/cameras/0/perspective/yfov", {1, 0.5}, "STEP"));
  Poser poser(scene, cameraNode(scene, "p"));
  EXPECT_EQ(poser.at(1.99).camera.vertical_fov, 1);
  EXPECT_EQ(poser.at(2).camera.vertical_fov, 0.5);
  EXPECT_EQ(poser.at(1.99, 2).camera.vertical_fov, 0.5);
}

TEST_F(Gltf, OtherPointersAreNamed) {
  Json json = Pointed().moving("/materials/0/pbrMetallicRoughness/roughnessFactor", {0, 1});
  Scene scene = load(json);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_NE(scene.warnings[0].find("'/materials/0/pbrMetallicRoughness/roughnessFactor' cannot be animated"),
            std::string::npos);
  for (const char* nothing : {"/nodes/9/scale", "/cameras/0/orthographic/ymag", "/cameras/5/perspective/yfov"}) {
    std::vector<float> values(std::string(nothing).ends_with("scale") ? 6 : 2, 1.0f);
    EXPECT_NE(failure(Pointed().moving(nothing, values)).find("does not exist"), std::string::npos) << nothing;
  }
}

TEST_F(Gltf, ChannelsOfOneAnimationHaveDifferentTargets) {
  Json json = Pointed().moving("/nodes/0/translation", {0, 0, 0, 4, 0, 0});
  json["animations"][0]["channels"].push_back({{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}});
  EXPECT_NE(failure(json).find("drives /nodes/0/translation, which another channel drives too"), std::string::npos);
}

// ---- Cuts

// The mesh moves 4 m along x in two seconds and starts again.
Json sliding() { return Pointed().moving("/nodes/0/translation", {0, 0, 0, 4, 0, 0}); }

TEST_F(Gltf, ScenesNodesAndAnimationsHaveCuts) {
  Json json = sliding();
  json["scenes"][0]["extras"]["cuts"] = {0.5, 1};
  json["nodes"][1]["extras"]["cuts"] = {2.5};
  json["animations"][0]["extras"]["cuts"] = {0, 1.5, 2};
  Scene scene = load(json);
  EXPECT_EQ(scene.cuts, (std::vector<double>{0.5, 1}));
  EXPECT_EQ(scene.nodes[1].cuts, std::vector<double>{2.5});
  EXPECT_EQ(scene.animations[0].cuts, (std::vector<double>{0, 1.5, 2}));
  EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(Gltf, ExtrasOfAnotherFormHaveNoCuts) {
  for (const char* text : {"3", "\"cuts\"", "[1, 0]", "{\"cuts\": []}", "{\"other\": 1}"}) {
    const Json extras = Json::parse(text);
    Json json = sliding();
    json["scenes"][0]["extras"] = json["nodes"][1]["extras"] = json["animations"][0]["extras"] = extras;
    EXPECT_EQ(failure(json), "") << text;
    EXPECT_TRUE(load(json).cuts.empty());
  }
}

TEST_F(Gltf, MalformedCutsAreRefusedWithTheirPlace) {
  const std::pair<const char*, const char*> places[] = {
      {"/scenes/0/extras/cuts", "a.gltf: scenes[0].extras: "},
      {"/nodes/1/extras/cuts", "a.gltf: nodes[1].extras: "},
      {"/animations/0/extras/cuts", "a.gltf: animations[0].extras: "}};
  const std::pair<const char*, const char*> mistakes[] = {
      {"0.5", "'cuts' is not a list"},
      {"[\"half\"]", "'cuts' has an element that is not a finite number"},
      {"[1, 0.5]", "'cuts' do not increase"},
      {"[1, 1]", "'cuts' do not increase"}};
  for (const auto& [pointer, place] : places)
    for (const auto& [cuts, what] : mistakes) {
      Json json = sliding();
      json[Json::json_pointer(pointer)] = Json::parse(cuts);
      const std::string found = failure(json);
      EXPECT_TRUE(found.ends_with(std::string(place) + what)) << found;
    }
  for (double beyond : {-0.5, 2.5}) {
    Json json = sliding();
    json["animations"][0]["extras"]["cuts"] = {beyond};
    EXPECT_NE(failure(json).find("animations[0].extras: 'cuts' has"), std::string::npos) << failure(json);
  }
}

// Exposure from 1.75 s to 2.25 s, raster time at its end: the clip starts again within the exposure.
TEST_F(Gltf, ClipIsCutOnlyForItsTargets) {
  auto placeAt = [&](const Json& json, const std::string& animation, double time_s) {
    const Scene scene = load(json);
    const FramePoser poser(scene, cameraNode(scene, "p"), animation, {2.25, 1.75, 2.25});
    return poser.at(time_s).world_from_instance.at(0)[3].x - 1;  // the mesh's centre is at x = 1
  };
  Json json = sliding();
  EXPECT_NEAR(placeAt(json, "all", 1.75), 3.5, 1e-6);
  json["animations"][0]["extras"]["cuts"] = {2};
  EXPECT_NEAR(placeAt(json, "all", 1.75), 0.5, 1e-6);
  EXPECT_NEAR(placeAt(json, "none", 1.75), 0, 1e-6);
  json = Pointed().moving("/cameras/0/perspective/yfov", {1, 0.5});
  json["animations"][0]["extras"]["cuts"] = {0};
  const Scene scene = load(json);
  EXPECT_EQ(FramePoser(scene, cameraNode(scene, "p"), "all", {2.25, 1.75, 2.25}).cameraTime(1.75), 2.25);
  EXPECT_EQ(FramePoser(scene, cameraNode(scene, "o"), "all", {2.25, 1.75, 2.25}).cameraTime(1.75), 1.75);
}

}  // namespace gltf_features_test
}  // namespace strobe::scene
