// SPDX-License-Identifier: MIT
// Lenses and lights that change within the exposure, moved by KHR_animation_pointer, against their closed forms.
#include <fmt/format.h>

#include <cmath>

#include "common/source.h"
#include "common/temporary_folder.h"
#include "oracle/render.h"
#include "scene/gltf_asset.h"

namespace strobe::oracle {
namespace render_lenses_test {

constexpr int kWidth = 64, kHeight = 40;
constexpr double kDistance = 5;  // from the camera to the card

class RenderLenses : public RenderTest {
 protected:
  static Path file() { return testing::processFolder() / "a.gltf"; }

  // A white card of 4 by 4 m that faces a camera and a directional light. `pointer` changes from one value to the other
  // within a second.
  static lab::Shot shot(const std::string& pointer, float from, float to, bool unlit, double vertical_fov = 1) {
    scene::Asset asset;
    asset.add<float>({-2, -2, 0, 2, -2, 0, 2, 2, 0, -2, -2, 0, 2, 2, 0, -2, 2, 0}, "VEC3", 3, 5126);
    int times = asset.add<float>({0, 1}, "SCALAR", 1, 5126), values = asset.add<float>({from, to}, "SCALAR", 1, 5126);
    Json& json = asset.json;
    json["nodes"] = Json::parse(R"([{"mesh":0},{"camera":0,"name":"eye","translation":[0,0,5]},
        {"translation":[0,0,5],"extensions":{"KHR_lights_punctual":{"light":0}}}])");
    json["scenes"][0]["nodes"] = {0, 1, 2};
    json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", vertical_fov}, {"znear", .1}}}}};
    json["extensions"]["KHR_lights_punctual"]["lights"] = Json::parse(R"([{"type":"directional","intensity":2}])");
    json["extensionsUsed"] = {"KHR_lights_punctual", "KHR_animation_pointer", "KHR_materials_unlit"};
    json["materials"] = Json::parse(R"([{"pbrMetallicRoughness":{"metallicFactor":0}}])");
    if (unlit) json["materials"][0]["extensions"]["KHR_materials_unlit"] = Json::object();
    asset.primitive()["material"] = 0;
    Json target = {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", pointer}}}}}};
    json["animations"] = Json::array({{{"samplers", Json::array({{{"input", times}, {"output", values}}})},
                                       {"channels", Json::array({{{"sampler", 0}, {"target", target}}})}}});
    scene::writeQuickly(file(), asset.whole().dump());
    lab::Shot result;
    result.scene = file();
    result.width = kWidth;
    result.height = kHeight;
    result.fps = 10;
    result.frame = 5;
    result.exposure = 1;
    return result;
  }
};

// A point at distance r from the middle at the raster time is at r tan(a) / tan(b) later; a and b are half the angles
// of view at the raster time and at the later time.
TEST_F(RenderLenses, ZoomsCauseDisplacements) {
  lab::Shot zoom = shot("/cameras/0/perspective/yfov", 1.2f, .4f, true);
  zoom.anchor = "centre";
  lab::Picture picture = render(with(zoom, sourceFolder() / "tests/oracle/pipelines/two_ways.lua", {}, "centre"));
  auto half = [](double time_s) { return std::tan((1.2 - .8 * time_s) / 2); };
  double stretch = half(.5) / half(.55) - half(.5) / half(.45);
  double longest = 0;
  for (const char* output : {"velocity", "ray_velocity"}) {
    const image::Image& velocity = imageOf(picture, output);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        double rx = x + .5 - kWidth / 2., ry = y + .5 - kHeight / 2.;
        EXPECT_NEAR(velocity.at(x, y, 0), rx * stretch, 1e-4) << output << " " << x << " " << y;
        EXPECT_NEAR(velocity.at(x, y, 1), ry * stretch, 1e-4) << output << " " << x << " " << y;
        longest = std::max(longest, std::hypot(rx, ry) * stretch);
      }
  }
  EXPECT_GT(longest, 3);
}

// The card's border moves outwards: a pixel is white after the border has passed its centre.
TEST_F(RenderLenses, TruthBlursZooms) {
  const int samples = 32;
  lab::Shot zoom = with(shot("/cameras/0/perspective/yfov", 1.2f, .8f, true), "ground_truth",
                        {fmt::format("samples={}", samples)}, "centre");
  image::Image color = colorOf(render(zoom));
  int between = 0;
  for (int x = 0; x < kWidth; ++x) {
    double r = std::abs(x + .5 - kWidth / 2.), covered = 0;
    for (int i = 0; i < 4096; ++i) {
      double angle = 1.2 - .4 * (.45 + .1 * (i + .5) / 4096);
      covered += 2 / kDistance / std::tan(angle / 2) * kHeight / 2 > r;
    }
    covered /= 4096;
    between += covered > .05 && covered < .95;
    EXPECT_NEAR(color.at(x, kHeight / 2, 0), covered, 1. / samples) << x;
  }
  EXPECT_GE(between, 2);
}

// With full shading a point averages the light over the exposure; with frozen shading it has the light of the raster
// time.
TEST_F(RenderLenses, LightsFadeWithinTheExposure) {
  lab::Shot fading = shot("/extensions/KHR_lights_punctual/lights/0/intensity", 4, 0, false);
  auto middle = [&](const std::string& shading) {
    lab::Picture picture = render(with(fading, "ground_truth", {"samples=64", "shading=" + shading}, "end"));
    return colorOf(picture).at(kWidth / 2, kHeight / 2, 0);
  };
  double frozen = middle("frozen"), full = middle("full");
  EXPECT_GT(frozen, .1);
  EXPECT_NEAR(full / frozen, (4 - 4 * .45) / (4 - 4 * .5), 1e-4);  // the middle of the exposure is at .45 s
}

}  // namespace render_lenses_test
}  // namespace strobe::oracle
