// SPDX-License-Identifier: MIT
// Clips that drive one target, repeated names in a file, and front faces of skinned meshes, in files and in Lua.
#include "scene/clips.h"

#include <cmath>

#include "common/refusal.h"
#include "scene/bend.h"
#include "scene/gltf_asset.h"
#include "scene/json_scene.h"
#include "scene/motion.h"

namespace strobe::scene {
namespace clips_test {

// ---- Clips of one target

// A triangle, a camera, and a clip of one second for each pair of a name and a target.
struct Clips {
  Asset asset = triangle();
  int times;
  Clips() {
    times = asset.add<float>({0, 1}, "SCALAR", 1, 5126);
    asset.json["animations"] = Json::array();
  }
  Clips& clip(const std::string& name, const std::string& path, const std::vector<float>& values) {
    const int width = path == "rotation" ? 4 : 3;
    const int output = asset.add(values, width == 4 ? "VEC4" : "VEC3", width, 5126);
    asset.json["animations"].push_back(
        {{"name", name},
         {"samplers", Json::array({{{"input", times}, {"output", output}}})},
         {"channels", Json::array({{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}})}});
    return *this;
  }
  Json whole() { return asset.whole(); }
};

dvec3 placeAt(const Scene& scene, double time_s, const std::string& animation = "all") {
  return dvec3(Poser(scene, -1, animation).nodesAt(time_s, time_s).at(0)[3]);
}

TEST_F(Gltf, FirstClipOfATargetPlays) {
  const std::vector<float> in_x = {0, 0, 0, 1, 0, 0}, in_y = {0, 0, 0, 0, 1, 0};
  const Scene walk_run = load(Clips()
                                  .clip("walk", "translation", in_x)
                                  .clip("run", "translation", in_y)
                                  .clip("grow", "scale", {1, 1, 1, 3, 3, 3})
                                  .whole());
  EXPECT_EQ(placeAt(walk_run, 0.5), dvec3(0.5, 0, 0));
  EXPECT_EQ(placeAt(walk_run, 0.5, "run"), dvec3(0, 0.5, 0));
  EXPECT_EQ(clipsOf(walk_run, "all").size(), 2u) << "a clip with another target plays too";
  EXPECT_EQ(walk_run.animations[1].yields_to, 0);
  EXPECT_EQ(walk_run.animations[1].shared_target, "translation of node 'node_0'");
  const Scene run_walk = load(Clips().clip("run", "translation", in_y).clip("walk", "translation", in_x).whole());
  EXPECT_EQ(placeAt(run_walk, 0.5), dvec3(0, 0.5, 0));
}

// A clip that does not play does not block its targets.
TEST(Clips, OnlyPlayingClipsBlockTargets) {
  Scene scene;
  scene.nodes.resize(3);
  auto clip = [&](std::initializer_list<int> nodes) {
    Animation animation;
    for (int node : nodes)
      animation.tracks.push_back({node, Track::Target::Scale, Track::Interpolation::Linear, {0}, {dvec4(1)}});
    scene.animations.push_back(animation);
  };
  clip({0});
  clip({0, 1});
  clip({1, 2});
  clip({2});
  yieldClips(scene);
  EXPECT_EQ(scene.animations[0].yields_to, -1);
  EXPECT_EQ(scene.animations[1].yields_to, 0);
  EXPECT_EQ(scene.animations[2].yields_to, -1);
  EXPECT_EQ(scene.animations[3].yields_to, 2);
}

TEST(Clips, OneAnimationDrivesATargetOnce) {
  const char* const kTrack = R"({"kind":"track","node":"a","times":[0],"values":[[0,0,0]]})";
  auto failure = [&](const std::string& animations) -> std::string {
    return testing::refusalOf([&] {
      sceneFromJson(
          Json::parse(R"({"kind":"scene","nodes":[{"kind":"node","name":"a"}],"animations":[)" + animations + "]}"),
          "test.lua");
    });
  };
  auto animation = [](const std::string& name, const std::string& tracks) {
    return R"({"kind":"animation","name":")" + name + R"(","tracks":[)" + tracks + "]}";
  };
  const std::string twice = failure(animation("x", std::string(kTrack) + "," + kTrack));
  EXPECT_NE(twice.find("track: another track drives the translation of node 'a'"), std::string::npos) << twice;
  const std::string named = failure(animation("x", kTrack) + "," + animation("x", kTrack));
  EXPECT_NE(named.find("animation 'x': another animation has this name"), std::string::npos) << named;
  EXPECT_EQ(failure(animation("x", kTrack) + "," + animation("y", kTrack)), "");
}

// ---- Names

TEST_F(Gltf, UniqueNamesAreUnchanged) {
  Asset asset = triangle();
  auto namesOf = [&](const std::vector<const char*>& names) {
    asset.json["nodes"] = Json::array();
    for (const char* name : names) asset.json["nodes"].push_back(*name ? Json{{"name", name}} : Json::object());
    std::vector<std::string> found;
    for (const Node& node : load(asset.whole()).nodes) found.push_back(node.name);
    return found;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(namesOf({"a", "a", "a#2"}), (Names{"a", "a#3", "a#2"}));
  EXPECT_EQ(namesOf({"a#2", "a", "a"}), (Names{"a#2", "a", "a#3"}));
  EXPECT_EQ(namesOf({"a", "a", "a"}), (Names{"a", "a#2", "a#3"}));
  EXPECT_EQ(namesOf({"a#2", "a#2", "a", "a"}), (Names{"a#2", "a#2#2", "a", "a#3"}));
  EXPECT_EQ(namesOf({"", "node_0", ""}), (Names{"node_0#2", "node_0", "node_2"}));
}

TEST_F(Gltf, ClipsNamedLikeChoicesAreRenamed) {
  const Scene scene =
      load(Clips().clip("all", "translation", {0, 0, 0, 1, 0, 0}).clip("none", "scale", {1, 1, 1, 1, 1, 1}).whole());
  EXPECT_EQ(scene.animations[0].name, "all#2");
  EXPECT_EQ(scene.animations[1].name, "none#2");
}

// ---- Front faces

// A triangle with one joint or, if `both`, two joints; a node's scale is keyed from (1, 1, 1) to (-1, 1, 1).
Json keyedMirror(bool both, int keyed_node) {
  Clips clips;
  Asset& asset = clips.asset;
  asset.json["nodes"] = Json::parse(R"([{"mesh":0,"skin":0},{},{}])");
  asset.json["scenes"][0]["nodes"] = {0, 1, 2};
  const uint8_t other = both ? 1 : 0;
  const int joints = asset.add<uint8_t>({0, 0, 0, 0, other, 0, 0, 0, 0, 0, 0, 0}, "VEC4", 4, 5121);
  const int shares = asset.add<float>({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4", 4, 5126);
  asset.primitive()["attributes"]["JOINTS_0"] = joints;
  asset.primitive()["attributes"]["WEIGHTS_0"] = shares;
  asset.json["skins"] = Json::array({{{"joints", {1, 2}}}});
  clips.clip("flip", "scale", {1, 1, 1, -1, 1, 1});
  asset.json["animations"][0]["channels"][0]["target"]["node"] = keyed_node;
  return asset.whole();
}

// The sign of the determinant of the skin's node at that time decides the front face; joints decide the positions.
TEST_F(Gltf, FrontOfASkinFollowsItsNodeAtEachTime) {
  for (bool both : {false, true})
    for (int keyed_node : {0, 1}) {
      const Scene scene = load(keyedMirror(both, keyed_node));
      const Instance instance = instancesOf(scene).at(0);
      EXPECT_TRUE(bends(scene, instance));
      for (double time_s : {0., 0.25, 0.75, 1.}) {
        const Pose pose = Poser(scene, -1).at(time_s);
        const bool node_mirrors = keyed_node == 0 && time_s > 0.5, joint_mirrors = keyed_node == 1;
        EXPECT_EQ(glm::determinant(dmat3(pose.world_from_instance.at(0))) < 0, node_mirrors) << both << time_s;
        const std::vector<BentVertex> corners = bentVertices(scene, instance, pose.bends.at(0));
        const dvec3 corner = dvec3(pose.world_from_instance.at(0) * dvec4(corners.at(1).position, 1));
        const double x = joint_mirrors && !both ? 2 * (1 - 2 * time_s) : 2;
        EXPECT_LE(glm::distance(corner, dvec3(x, 0, 0)), 1e-6) << both << keyed_node << time_s;
      }
    }
}

}  // namespace clips_test
}  // namespace strobe::scene
