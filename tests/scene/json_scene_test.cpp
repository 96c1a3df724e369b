// SPDX-License-Identifier: MIT
#include "scene/json_scene.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/refusal.h"
#include "scene/motion.h"

namespace strobe::scene {
namespace json_scene_test {

Json parsed(const char* text) { return Json::parse(text); }

std::string failure(const Json& json) {
  return testing::refusalOf([&] { sceneFromJson(json, "test.lua", {{"fps", false, 1, 100}}); });
}

TEST(JsonScene, TrackWithoutTimesIsAMistake) {
  std::string text = failure(parsed(R"({"kind":"scene","nodes":[{"kind":"node","name":"a"}],
    "animations":[{"kind":"animation","name":"x","tracks":[{"kind":"track","node":"a"}]}]})"));
  EXPECT_NE(text.find("track: needs 'times'"), std::string::npos) << text;
  EXPECT_NE(text.find("track: needs 'values'"), std::string::npos) << text;
}

TEST(JsonScene, BuildsNodesMeshesAndMotion) {
  Scene scene = sceneFromJson(parsed(R"({"kind":"scene","name":"room","environment":{"sky":[1,2,3],"ground":[0,0,0.5]},
    "nodes":[
      {"kind":"node","name":"vase","position":[1,2,3],"scale":2,
       "shape":{"kind":"shape","type":"sphere","radius":0.5,"segments":8},
       "material":{"kind":"material","name":"clay","color":[0.5,0.2,0.1],"roughness":0.4,
         "color_texture":{"kind":"use","texture":{"kind":"texture","type":"checker","size":[8,8],
           "colors":[[1,1,1],[0,0,0]],"count":2},"scale":[2,2]}},
       "motion":{"velocity":[1,0,0],"degrees_per_second":90,"rest_time":1},
       "children":[{"kind":"node","name":"copy","rotation":[0,90,0],"position":[0,0,-1],
         "shape":{"kind":"shape","type":"sphere","segments":8,"radius":0.5},
         "material":{"kind":"material","roughness":0.4,"name":"clay","color":[0.5,0.2,0.1],
         "color_texture":{"kind":"use","texture":{"kind":"texture","type":"checker","size":[8,8],
           "colors":[[1,1,1],[0,0,0]],"count":2},"scale":[2,2]}}}]},
      {"kind":"node","name":"lamp","light":{"kind":"light","type":"spot","intensity":10,"color":[1,0.5,0],
        "outer_cone":60}},
      {"kind":"node","name":"eye","position":[0,1,5],"look_at":[0,1,0],
       "camera":{"kind":"camera","type":"perspective","fov":60}}],
    "animations":[{"kind":"animation","name":"slide","tracks":[{"kind":"track","node":"copy",
      "times":[0,2],"values":[[0,0,0],[0,2,0]]}]}]})"),
                              "test.lua");
  ASSERT_EQ(scene.nodes.size(), 4u);
  EXPECT_EQ(scene.nodes[1].parent, 0);
  EXPECT_EQ(scene.meshes.size(), 1u) << "equal meshes are shared";
  EXPECT_EQ(scene.nodes[1].mesh, scene.nodes[0].mesh);
  EXPECT_EQ(scene.materials.size(), 2u);
  EXPECT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(scene.materials[1].base_color_texture.uv_transform[0][0], 2);
  EXPECT_EQ(scene.lights[0].emitted(), vec3(10, 5, 0));
  EXPECT_NEAR(scene.lights[0].outer_cone, std::acos(0.5), 1e-12);
  EXPECT_EQ(scene.cameras[0].name, "eye");
  EXPECT_EQ(scene.environment.sky, vec3(1, 2, 3));
  ASSERT_EQ(scene.motions.size(), 1u);
  EXPECT_NEAR(scene.motions[0].angular_velocity, std::asin(1.0), 1e-12);
  EXPECT_EQ(scene.animations.at(0).duration, 2);
  Pose pose = Poser(scene, cameraNode(scene, "eye")).at(1);
  EXPECT_NEAR(pose.world_from_instance[1][3].y, 4, 1e-12);  // 2 + 2 * 1
}

TEST(JsonScene, LookAtTurnsMinusZ) {
  Scene scene = sceneFromJson(parsed(R"({"kind":"scene","nodes":[{"kind":"node","position":[1,2,3],"look_at":[4,2,-1],
    "camera":{"kind":"camera","type":"perspective"}}]})"),
                              "test.lua");
  dmat4 world = Poser(scene, 0).at(0).world_from_camera;
  EXPECT_NEAR(-world[2].x, 0.6, 1e-12);
  EXPECT_NEAR(-world[2].z, -0.8, 1e-12);
  EXPECT_NEAR(world[1].y, 1, 1e-12);
}

TEST(JsonScene, ReportsAllMistakesWithTheirPlaces) {
  std::string text = failure(parsed(R"({"kind":"scene","place":{"file":"a.lua","line":1},"nodes":[
    {"kind":"node","name":"vase","place":{"file":"a.lua","line":3},"postion":[0,0,0],
     "shape":{"kind":"shape","type":"sphere","radius":-1,"place":{"file":"a.lua","line":4}}},
    {"kind":"node","name":"vase","place":{"file":"a.lua","line":6},"shape":{"kind":"material"}},
    {"kind":"node","name":"eye","place":{"file":"a.lua","line":8},"position":[0,"x",0]}],
    "animations":[{"kind":"animation","name":"n","place":{"file":"a.lua","line":9},"tracks":[{"kind":"track",
      "node":"vace","times":[0],"values":[[0,0,0]]}]}]})"));
  for (const char* expected :
       {"a.lua:3: node 'vase': unknown key 'postion'; did you mean 'position'?",
        "a.lua:4: sphere: 'radius' = -1 is below min 1e-09", "a.lua:6: node 'vase': another node has this name",
        "a.lua:6: shape: is not a shape", "a.lua:8: node 'eye': 'position' has string where a number is expected",
        "a.lua:9: track: unknown node 'vace'; did you mean 'vase'?"}) {
    EXPECT_NE(text.find(expected), std::string::npos) << expected << "\nin\n" << text;
  }
}

// The list of keys includes keys that are only tested for presence, and keys of other branches.
TEST(JsonScene, UnknownKeyListsAllKeys) {
  std::string text = failure(parsed(R"({"kind":"scene","nodes":[{"kind":"node","name":"eye","lookat":[0,0,0]},
    {"kind":"node","name":"b","qqqqqqqq":1}]})"));
  EXPECT_NE(text.find("node 'eye': unknown key 'lookat'; did you mean 'look_at'?"), std::string::npos) << text;
  EXPECT_NE(text.find("node 'b': unknown key 'qqqqqqqq'; it has camera, children, cuts, gltf, light, look_at, "
                      "material, motion, name, "
                      "parts, position, rotation, scale, shape"),
            std::string::npos)
      << text;
}

TEST(JsonScene, WrongKindsAreRefused) {
  for (const char* bad :
       {"null", "[]", "{}", "3", R"({"kind":"scene"})", R"({"kind":"scene","nodes":3})",
        R"({"kind":"scene","nodes":[],"shot":{"with":3}})", R"({"kind":"scene","nodes":[],"shot":{"fps":0}})",
        R"({"kind":"scene","nodes":[],"shot":{"fps":"24"}})", R"({"kind":"scene","nodes":[null]})",
        R"({"kind":"scene","nodes":[[]]})",
        R"({"kind":"scene","nodes":[{"kind":"node","shape":{"kind":"shape","type":"lathe","profile":[[0,0]]}}]})",
        R"({"kind":"scene","nodes":[{"kind":"node","shape":{"kind":"shape","type":"box","size":[0,1,1]}}]})",
        R"({"kind":"scene","nodes":[{"kind":"node","shape":{"kind":"shape","type":"triangles",
            "positions":[[0,0,0],[1,0,0],[0,1,0]],"indices":[1,2,4]}}]})",
        R"({"kind":"scene","nodes":[{"kind":"node","material":{"kind":"material"}}]})",
        R"({"kind":"scene","nodes":[{"kind":"node","scale":[1,1]}]})",
        R"({"kind":"scene","nodes":[{"kind":"node","shape":{"kind":"shape","type":"quad"},"material":{"kind":"material",
            "color_texture":{"kind":"texture","type":"texels","width":2,"height":2,"texels":[[1,1,1]]}}}]})",
        R"({"kind":"scene","nodes":[],"animations":[{"kind":"animation","name":"a","tracks":[{"kind":"track","node":"x",
            "times":[1,0],"values":[[0,0,0],[0,0,0]]}]}]})"}) {
    EXPECT_NE(failure(parsed(bad)), "") << bad;
  }
}

TEST(JsonScene, SuggestionsForAShotAreChecked) {
  EXPECT_EQ(failure(parsed(R"({"kind":"scene","nodes":[],"shot":{"fps":24}})")), "");
  EXPECT_NE(failure(parsed(R"({"kind":"scene","nodes":[],"shot":{"fpt":24}})")).find("fpt"), std::string::npos);
}

TEST(JsonScene, DeepNestingIsRefused) {
  Json node = parsed(R"({"kind":"node"})");
  for (int i = 0; i < 300; ++i) node = Json{{"kind", "node"}, {"children", Json::array({node})}};
  EXPECT_NE(failure(Json{{"kind", "scene"}, {"nodes", Json::array({node})}}).find("nested deeper"), std::string::npos);
}

TEST(JsonScene, LiteralTrianglesCountFromOne) {
  Scene scene = sceneFromJson(parsed(R"({"kind":"scene","nodes":[{"kind":"node","shape":{"kind":"shape",
    "type":"triangles","positions":[[0,0,0],[2,0,0],[0,2,0]],"indices":[1,2,3]}}]})"),
                              "test.lua");
  const Mesh& mesh = scene.meshes.at(0);
  EXPECT_EQ(dvec3(mesh.geometries[0].vertices[1].position) + mesh.origin, dvec3(2, 0, 0));
  EXPECT_EQ(mesh.geometries[0].vertices[1].normal, vec3(0, 0, 1));
}

}  // namespace json_scene_test
}  // namespace strobe::scene
