// SPDX-License-Identifier: MIT
// Motion without blur: cuts, and shares of the camera's and the objects' motion. Each picture must equal a scene with
// correspondingly less motion, by every method and by truth. Also exposures in seconds.
#include <fmt/format.h>

#include <set>

#include "common/temporary_folder.h"
#include "oracle/render.h"
#include "scene/gltf_asset.h"

namespace strobe::oracle {
namespace render_jumps_test {

struct Method {
  std::string pipeline;
  std::vector<std::string> settings;
};
// One method for each way to read motion. The gathers of other papers read the same displacements as the first.
const Method kGather = {"mcguire2012", {}}, kExtrapolated = {"hybrid_layered", {"displacement=extrapolated"}};
const std::vector<Method>& methods() {
  static const std::vector<Method> methods = {
      kGather,
      {"hybrid", {}},
      {"hybrid_layered", {}},
      {"adaptive", {}},
      {"hybrid_layered", {"range=split"}},
      kExtrapolated,
      {"ground_truth", {"samples=16"}},
      {"ground_truth", {"samples=16", "times=stratified", "shading=full"}},
      {"ground_truth", {"samples=16", "mode=raster"}},
  };
  return methods;
}

lab::Shot jumps(const Numbers& numbers) { return shotOf("jumps", 96, 64, numbers); }

class RenderJumps : public RenderTest {
 protected:
  static image::Image drawn(const lab::Shot& shot, const Method& method, const std::string& anchor) {
    return colorOf(render(with(shot, method.pipeline, method.settings, anchor)));
  }
  // Expects the same picture, bit for bit, by every method.
  static void expectAlike(const lab::Shot& a, const lab::Shot& b, const std::string& anchor, const std::string& what) {
    for (const Method& method : methods())
      EXPECT_TRUE(identical(drawn(a, method, anchor), drawn(b, method, anchor)))
          << what << ", " << method.pipeline << " " << fmt::format("{}", fmt::join(method.settings, " ")) << ", "
          << anchor;
  }
};

// --- Cuts

TEST_F(RenderJumps, SceneCutsRemoveAllBlur) {
  const std::pair<std::string, double> cuts[] = {{"end", -.3},           {"end", 0},    {"centre", .2},
                                                 {"centre", -.5 + 1e-6}, {"start", .5}, {"start", 1}};
  image::Image sharp = drawn(jumps({}), {"none", {}}, "end");
  for (const auto& [anchor, cut] : cuts)
    for (const Method& method : methods())
      EXPECT_TRUE(identical(drawn(jumps({{"scene_cut", cut}}), method, anchor), sharp))
          << method.pipeline << " " << anchor << " " << cut;
}

// The exposure does not cross the cut.
TEST_F(RenderJumps, CutsOutsideTheExposureChangeNothing) {
  const std::pair<std::string, double> cuts[] = {{"end", -1.01}, {"end", .1}, {"start", 0}, {"start", 1.01}};
  for (const auto& [anchor, cut] : cuts)
    for (const Method& method : methods()) {
      if (method.settings == std::vector<std::string>{"displacement=extrapolated"}) continue;  // reads the frame before
      EXPECT_TRUE(identical(drawn(jumps({{"scene_cut", cut}}), method, anchor), drawn(jumps({}), method, anchor)))
          << method.pipeline << " " << anchor << " " << cut;
    }
}

// Motion of the previous frame is not extrapolated over a cut.
TEST_F(RenderJumps, CutsBeforeTheExposurePreventExtrapolation) {
  Method extrapolated{"hybrid", {"displacement=extrapolated"}};  // traces no rays at sample times
  EXPECT_TRUE(
      identical(drawn(jumps({{"scene_cut", -1.5}}), extrapolated, "end"), drawn(jumps({}), {"none", {}}, "end")));
}

TEST_F(RenderJumps, CutsOfANodeRemoveItsMotion) {
  for (const char* anchor : {"end", "centre", "start"}) {
    double cut = anchor == std::string("start") ? .4 : -.4;
    expectAlike(jumps({{"a_cut", cut}}), jumps({{"a_x", 0}}), anchor, "object");
    expectAlike(jumps({{"camera_cut", cut}}), jumps({{"camera_x", 0}}), anchor, "camera");
  }
}

// Two cards `a` and `b` of a glTF file and its camera. Each moves 2 m within a second by its own clip, except for nodes
// in `held`, which keep their position at half a second. `extend` edits the file's JSON.
class RenderJumpsInGltf : public RenderJumps {
 protected:
  static Path file() { return testing::processFolder() / "a.gltf"; }

  static lab::Shot shot(const std::set<int>& held, const std::function<void(Json&)>& extend = {}) {
    scene::Asset asset;
    asset.add<float>({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, -1, 0, 1, 1, 0, -1, 1, 0}, "VEC3", 3, 5126);
    const int times = asset.add<float>({0, 1}, "SCALAR", 1, 5126);
    Json& json = asset.json;
    json["nodes"] = Json::parse(R"([{"mesh":0,"name":"a"},{"mesh":0,"name":"b"},{"camera":0,"name":"eye"},
        {"mesh":0,"name":"wall","translation":[0,0,-4],"scale":[2,2,1]}])");
    json["scenes"][0]["nodes"] = {0, 1, 2, 3};
    json["cameras"] = Json::parse(R"([{"type":"perspective","perspective":{"yfov":1,"znear":0.1}}])");
    json["animations"] = Json::array();
    for (int node = 0; node < 3; ++node) {
      const float x = node == 0 ? -1.5f : node == 1 ? 1.5f : 0, y = node == 1 ? 1 : 0, z = node == 2 ? 6 : 0;
      json["nodes"][size_t(node)]["translation"] = {x + 1, y, z};
      if (held.count(node)) continue;
      const int values = asset.add<float>({x, y, z, x + 2, y, z}, "VEC3", 3, 5126);
      json["animations"].push_back(
          {{"samplers", Json::array({{{"input", times}, {"output", values}}})},
           {"channels", Json::array({{{"sampler", 0}, {"target", {{"node", node}, {"path", "translation"}}}}})}});
    }
    if (json["animations"].empty()) json.erase("animations");
    if (extend) extend(json);
    scene::writeQuickly(file(), asset.whole().dump());
    lab::Shot result;
    result.scene = file();
    result.width = 96;
    result.height = 64;
    result.fps = 10;
    result.frame = 5;
    result.exposure = 1;
    return result;
  }

  static std::vector<image::Image> pictures(const lab::Shot& shot) {
    std::vector<image::Image> all;
    for (const Method& method : {kGather, Method{"hybrid_layered", {}}, kExtrapolated})
      all.push_back(drawn(shot, method, "end"));
    return all;
  }
  static void expectSame(const std::vector<image::Image>& a, const std::vector<image::Image>& b, const char* what) {
    for (size_t i = 0; i < a.size(); ++i) EXPECT_TRUE(identical(a[i], b[i])) << what << " " << i;
  }
};

TEST_F(RenderJumpsInGltf, SceneAndShotCutsRemoveAllBlur) {
  const Json cuts = {0.2, 0.45};
  lab::Shot moving = shot({}), option = moving;
  const image::Image none = drawn(moving, {"none", {}}, "end");
  const std::vector<image::Image> sharp(3, none);
  for (const image::Image& blurred : pictures(moving)) EXPECT_FALSE(identical(blurred, none));
  option.cuts = "0.2,0.45";
  expectSame(pictures(option), sharp, "shot");
  option.cuts = "0.4,0.51";  // the exposure starts at the first cut and ends before the second
  expectSame(pictures(option), pictures(moving), "outside");
  expectSame(pictures(shot({}, [&](Json& json) { json["scenes"][0]["extras"]["cuts"] = cuts; })), sharp, "scene");
}

TEST_F(RenderJumpsInGltf, CutsOfANodeOrClipRemoveItsMotion) {
  const Json cuts = {0.2, 0.45};
  for (int node : {0, 2}) {
    const std::vector<image::Image> held = pictures(shot({node}));
    auto cut = [&](const char* list) {
      return pictures(shot({}, [&](Json& json) { json[list][size_t(node)]["extras"]["cuts"] = cuts; }));
    };
    expectSame(cut("nodes"), held, "node");
    expectSame(cut("animations"), held, "clip");
  }
}

// --- Shares

TEST_F(RenderJumps, SharesOfMotionEqualSlowerMotion) {
  lab::Shot half_camera = jumps({}), no_objects = jumps({}), both = jumps({});
  half_camera.camera_blur = .5;
  no_objects.object_blur = 0;
  both.camera_blur = .25;
  both.object_blur = .5;
  for (const char* anchor : {"end", "centre"}) {
    expectAlike(half_camera, jumps({{"camera_x", 4}}), anchor, "half of the camera's motion");
    expectAlike(no_objects, jumps({{"a_x", 0}, {"b_y", 0}}), anchor, "no motion of the objects");
    expectAlike(both, jumps({{"camera_x", 2}, {"a_x", 8}, {"b_y", 4}}), anchor, "both");
  }
}

// The camera moves along with `a`. With the camera's motion left out, `a` is sharp, and so are static surfaces.
TEST_F(RenderJumps, FollowedNodesStaySharp) {
  const Numbers together = {{"a_x", 16}, {"camera_x", 16}};
  lab::Shot followed = jumps(together);
  followed.camera_blur = 0;
  followed.follow = "a";
  expectAlike(followed, jumps({{"a_x", 0}, {"camera_x", 0}}), "end", "followed");
  lab::Shot left = jumps(together);
  left.camera_blur = 0;
  EXPECT_GT(oracle::largestDifference(drawn(left, kGather, "end"), drawn(followed, kGather, "end")), .1);
  followed.follow = "nobody";
  EXPECT_THROW(render(with(followed, "none")), Error);
}

// `a` is at a depth of 100 m, `b` at 105 m and the static background at 120 m. Only the camera moves the background.
TEST_F(RenderJumps, MotionOutsideTheDepthRangeIsRemoved) {
  const Numbers rests = {{"camera_x", 0}};
  lab::Shot all = jumps({}), near = jumps(rests), far = jumps(rests), soft = jumps(rests);
  all.motion_depths = "0,inf";
  near.motion_depths = "90,102";
  far.motion_depths = "105,105";
  soft.motion_depths = "100,104,2";
  expectAlike(all, jumps({}), "end", "all");
  for (const char* anchor : {"end", "centre"}) {
    expectAlike(near, jumps({{"camera_x", 0}, {"b_y", 0}}), anchor, "near");
    expectAlike(far, jumps({{"camera_x", 0}, {"a_x", 0}}), anchor, "far");
    expectAlike(soft, jumps({{"camera_x", 0}, {"b_y", 4}}), anchor, "one metre into a soft border of two");
  }
  lab::Shot none = jumps({});
  none.motion_depths = "1,2";
  for (const Method& method : methods())
    EXPECT_LE(oracle::largestDifference(drawn(none, method, "end"), drawn(jumps({}), {"none", {}}, "end")), 1e-5)
        << method.pipeline;
}

// --- Seconds

// At half a second, for a 48th of a second: 20 px of the bar's motion at any frame rate, bit for bit.
TEST_F(RenderJumps, ExposuresInSecondsAreEqualAtAnyFrameRate) {
  for (const Method& method : methods()) {
    if (method.settings == std::vector<std::string>{"displacement=extrapolated"}) continue;  // depends on the rate
    bool drawn_by_frame = method.settings.size() > 1 && method.settings[1] == "times=stratified";
    if (drawn_by_frame) continue;
    image::Image first;
    for (double fps : {12., 24., 60., 144.}) {
      lab::Shot shot = shotOf("bar", 128, 4, {{"left", 40 - 480}, {"right", 80 - 480}, {"d_f", 20}});
      shot.fps = fps;
      shot.frame = int(fps / 2);
      shot.exposure_time = 1. / 48;
      image::Image color = drawn(shot, method, "end");
      if (first.values.empty()) first = color;
      EXPECT_TRUE(identical(color, first)) << method.pipeline << " " << fps;
    }
    EXPECT_GT(first.at(70, 1, 0), .1) << method.pipeline;
    EXPECT_LT(first.at(70, 1, 0), .99) << method.pipeline;
  }
}

}  // namespace render_jumps_test
}  // namespace strobe::oracle
