// SPDX-License-Identifier: MIT
// Objects that a scale of 0 flattens to a sheet. A square that already lies in the plane of the sheet does not change,
// so its picture is known, by every pipeline and ray tracing backend.
#include <fmt/format.h>

#include <cmath>

#include "common/source.h"
#include "common/temporary_folder.h"
#include "oracle/render.h"
#include "scene/gltf_asset.h"

namespace strobe::oracle {
namespace render_sheets_test {

constexpr int kSize = 40;

class RenderSheets : public RenderTest {
 protected:
  // A red square of 2 by 2 m, node 0, before a white wall with the square's shadow. `extend` edits the asset.
  static lab::Shot shot(const std::function<void(scene::Asset&)>& extend) {
    scene::Asset asset;
    asset.add<float>({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, -1, 0, 1, 1, 0, -1, 1, 0}, "VEC3", 3, 5126);
    asset.add<float>({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 3, 5126);
    Json& json = asset.json;
    json["meshes"] = Json::parse(R"([{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1},"material":0}]},
        {"primitives":[{"attributes":{"POSITION":0,"NORMAL":1},"material":1}]}])");
    json["materials"] = Json::parse(R"([{"doubleSided":true,"pbrMetallicRoughness":{"baseColorFactor":[1,0,0,1],
        "metallicFactor":0}},{"doubleSided":true,"pbrMetallicRoughness":{"metallicFactor":0}}])");
    json["nodes"] = Json::parse(R"([{"mesh":0,"name":"sheet"},{"mesh":1,"translation":[0,0,-1],"scale":[3,3,1]},
        {"camera":0,"translation":[0.02,0.01,4]},{"rotation":[0,0.5,0,0.8660254037844386],
        "extensions":{"KHR_lights_punctual":{"light":0}}}])");
    json["scenes"][0]["nodes"] = {0, 1, 2, 3};
    json["cameras"] = Json::parse(R"([{"type":"perspective","perspective":{"yfov":0.8,"znear":0.1}}])");
    json["extensions"]["KHR_lights_punctual"]["lights"] = Json::parse(R"([{"type":"directional","intensity":3}])");
    json["extensionsUsed"] = {"KHR_lights_punctual"};
    extend(asset);
    return shotOf(".gltf", asset.whole().dump());
  }

  // A shot of a new file.
  static lab::Shot shotOf(const std::string& ending, const std::string& text) {
    static int files = 0;
    lab::Shot result;
    result.scene = testing::processFolder() / fmt::format("{}{}", ++files, ending);
    scene::writeQuickly(result.scene, text);
    result.width = result.height = kSize;
    result.fps = 24;
    return result;
  }

  // Adds keys of the square over a second.
  static void addClip(scene::Asset& asset, const char* path, const std::vector<float>& from_to) {
    const int times = asset.add<float>({0, 1}, "SCALAR", 1, 5126), values = asset.add(from_to, "VEC3", 3, 5126);
    Json& clips = asset.json["animations"];
    if (clips.empty()) clips = Json::parse(R"([{"samplers":[],"channels":[]}])");
    clips[0]["samplers"].push_back({{"input", times}, {"output", values}});
    clips[0]["channels"].push_back(
        {{"sampler", clips[0]["samplers"].size() - 1}, {"target", {{"node", 0}, {"path", path}}}});
  }

  static int differing(const image::Image& a, const image::Image& b) {
    int pixels = 0;
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x)
        pixels += std::abs(a.at(x, y, 0) - b.at(x, y, 0)) + std::abs(a.at(x, y, 1) - b.at(x, y, 1)) > 1e-3;
    return pixels;
  }

  static int redIn(const image::Image& color) {
    int pixels = 0;
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x)
        pixels += color.at(x, y, 0) > 0.05f && color.at(x, y, 1) < 0.25f * color.at(x, y, 0);
    return pixels;
  }

  // Pictures of a shot by rasterisation, and by rays with every backend.
  static std::vector<std::pair<std::string, image::Image>> pictures(lab::Shot shot) {
    std::vector<std::pair<std::string, image::Image>> all = {{"raster", colorOf(render(with(shot, "none")))}};
    for (const std::string& backend : backends()) {
      shot.backend = backend;
      all.emplace_back(backend, colorOf(render(with(shot, "ground_truth", {"samples=2"}))));
    }
    return all;
  }

  // Expects the same picture from both shots, with a red square in it.
  static void expectSame(const lab::Shot& flat, const lab::Shot& full, const std::string& what) {
    const image::Image expected = colorOf(render(with(full, "none")));
    EXPECT_GT(redIn(expected), 100) << what;
    for (const auto& [way, color] : pictures(flat)) EXPECT_LE(differing(color, expected), 2) << what << ", " << way;
  }
};

// The square lies in the plane of the sheet, so nothing changes. The scale of 0 is the node's own, with and without
// mirroring and rotation; its parent's; and the parent's of a turned node, which projects the node along z.
TEST_F(RenderSheets, FlatteningAFlatSquareChangesNothing) {
  struct Case {
    const char* name;
    Json parent, node, plain;
    bool one_sided = false;
  };
  const double x = .18, y = .26, z = .12, w = std::sqrt(1 - x * x - y * y - z * z);
  // The effect of the rotation on x and y without its third row, which the projection removes.
  const Json projected = {{"matrix",
                           {1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 0, 0, 2 * (x * y - z * w),
                            1 - 2 * (x * x + z * z), 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}};
  const Json flat = {{"scale", {1, 1, 0}}}, turned = {{"rotation", {x, y, z, w}}};
  Json both = flat;
  both.update(turned);
  const std::vector<Case> cases = {{"own", {}, flat, Json::object()},
                                   {"own, one side", {}, flat, Json::object(), true},
                                   {"mirrored, one side", {}, {{"scale", {-1, 1, 0}}}, {{"scale", {-1, 1, 1}}}, true},
                                   {"turned, one side", {}, both, turned, true},
                                   {"parent", flat, Json::object(), Json::object()},
                                   {"parent of a turned node", flat, turned, projected, true}};
  for (const Case& one : cases) {
    auto make = [&](const Json& parent, const Json& node) {
      return shot([&](scene::Asset& asset) {
        Json& json = asset.json;
        if (one.one_sided) json["materials"][0].erase("doubleSided");
        json["nodes"][0].update(node);
        if (!parent.is_object()) return;
        json["nodes"].push_back(parent);
        json["nodes"].back()["children"] = {0};
        json["scenes"][0]["nodes"] = {1, 2, 3, 4};
      });
    };
    expectSame(make(one.parent, one.node), make({}, one.plain), one.name);
  }
}

// A flattened box shows its front, lit like a square.
TEST_F(RenderSheets, FlattenedSolidsShowTheirFaces) {
  auto shotOfShape = [&](const char* shape, const char* scale) {
    return shotOf(".lua", fmt::format(R"(local scene = require "strobe.scene"
return scene {{ nodes = {{
  scene.node {{ name = "sheet", scale = {}, shape = {},
    material = scene.material {{ color = {{ 1, 0, 0 }}, roughness = 1 }} }},
  scene.node {{ position = {{ 0, 0, -1 }}, shape = scene.quad {{ size = {{ 6, 6 }} }} }},
  scene.node {{ rotation = {{ 0, 60, 0 }}, light = scene.directional_light {{ intensity = 3 }} }},
  scene.node {{ position = {{ 0.02, 0.01, 4 }}, camera = scene.camera {{ fov = 45.8 }} }} }} }}
)",
                                      scale, shape));
  };
  expectSame(shotOfShape("scene.box { size = { 2, 2, 2 } }", "{ 1, 1, 0 }"),
             shotOfShape("scene.quad { size = { 2, 2 } }", "1"), "box");
}

// Two scales of 0 leave a line, which has no area.
TEST_F(RenderSheets, LinesAndPointsAreInvisible) {
  for (const Json& scale : {Json({1, 0, 0}), Json({0, 0, 1}), Json({0, 0, 0})})
    for (const auto& [way, color] :
         pictures(shot([&](scene::Asset& asset) { asset.json["nodes"][0]["scale"] = scale; })))
      EXPECT_EQ(redIn(color), 0) << scale.dump() << ", " << way;
}

// A moving sheet is blurred like the square, also where rays reveal it.
TEST_F(RenderSheets, MovingSheetsBlurLikeSquares) {
  auto moving = [&](const Json& scale) {
    lab::Shot result = shot([&](scene::Asset& asset) {
      asset.json["nodes"][0]["scale"] = scale;
      addClip(asset, "translation", {-6, 0, 0, 6, 0, 0});
    });
    result.frame = 12;
    result.exposure = 1;
    result.anchor = "centre";
    return result;
  };
  auto ways = [](const lab::Shot& one) {
    return std::vector<lab::Shot>{with(one, "ground_truth", {"samples=16"}), with(one, "adaptive")};
  };
  std::vector<image::Image> full, flat;
  for (const lab::Shot& way : ways(moving({1, 1, 1}))) full.push_back(colorOf(render(way)));
  for (const lab::Shot& way : ways(moving({1, 1, 0}))) flat.push_back(colorOf(render(way)));
  EXPECT_LE(rmsDifference(flat[0], full[0]), 1e-3);
  EXPECT_LE(rmsDifference(flat[1], full[0]), rmsDifference(full[1], full[0]) + 5e-3);
  EXPECT_GT(rms(full[0]), .05);
}

// At the time when a keyed scale is 0, and at the end of a scale that ends at 0, the square does not change.
TEST_F(RenderSheets, KeyedScalesOfZeroChangeNothing) {
  for (const auto& [at, last] : {std::pair(12, -1.f), std::pair(24, 0.f)}) {
    const int frame = at;
    auto keyed = [&](float to) {
      lab::Shot result = shot([&](scene::Asset& asset) { addClip(asset, "scale", {1, 1, 1, 1, 1, to}); });
      result.frame = frame;
      result.exposure = 0;
      return result;
    };
    expectSame(keyed(last), keyed(1), fmt::format("frame {}", frame));
  }
}

}  // namespace render_sheets_test
}  // namespace strobe::oracle
