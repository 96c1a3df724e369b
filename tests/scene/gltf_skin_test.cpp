// SPDX-License-Identifier: MIT
// Skins and morph targets of small assets: hand-computed positions of vertices, and every kind of damage.
#include <cmath>

#include "math/constants.h"
#include "scene/bend.h"
#include "scene/facts.h"
#include "scene/gltf_asset.h"
#include "scene/motion.h"

namespace strobe::scene {
namespace gltf_skin_test {

// A triangle: corner 0 follows joint 0, corner 1 joint 1, corner 2 half of each. Node 0 has the mesh, nodes 1 and its
// child 2 are the joints.
struct Skinned {
  Asset asset = triangle();
  int joints, weights, times;
  Skinned() {
    asset.json["nodes"] = Json::parse(R"([{"mesh":0,"skin":0,"translation":[50,60,70]},{"children":[2]},
        {"translation":[2,0,0]}])");
    asset.json["scenes"][0]["nodes"] = {0, 1};
    int normals = asset.add<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 3, 5126);
    joints = asset.add<uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, "VEC4", 4, 5121);
    weights = asset.add<float>({1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0}, "VEC4", 4, 5126);
    times = asset.add<float>({0, 1}, "SCALAR", 1, 5126);
    int binds = asset.add<float>(
        {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -2, 0, 0, 1}, "MAT4", 16,
        5126);
    attributes()["NORMAL"] = normals;
    attributes()["JOINTS_0"] = joints;
    attributes()["WEIGHTS_0"] = weights;
    asset.json["skins"] = Json::array({{{"joints", {1, 2}}, {"inverseBindMatrices", binds}}});
  }
  Json& attributes() { return asset.primitive()["attributes"]; }
  // A channel from key 0 to key 1 with this target.
  void drive(const Json& target, const std::vector<float>& values, const char* type, int width,
             const char* how = "LINEAR") {
    int output = asset.add(values, type, width, 5126);
    asset.json["animations"] =
        Json::array({{{"samplers", Json::array({{{"input", times}, {"output", output}, {"interpolation", how}}})},
                      {"channels", Json::array({{{"sampler", 0}, {"target", target}}})}}});
  }
};

std::vector<dvec3> worldCorners(const Scene& scene, double time_s, double held_s) {
  const std::vector<Instance> instances = instancesOf(scene);
  const Pose pose = Poser(scene, -1).at(time_s, held_s);
  std::vector<dvec3> corners;
  for (const BentVertex& vertex : bentVertices(scene, instances.at(0), pose.bends.at(0)))
    corners.push_back(dvec3(pose.world_from_instance.at(0) * dvec4(vertex.position, 1)));
  return corners;
}
std::vector<dvec3> worldCorners(const Scene& scene, double time_s) { return worldCorners(scene, time_s, time_s); }

// Tolerance 1e-6: positions and weights are in single precision.
void expectCorners(const std::vector<dvec3>& corners, const std::vector<dvec3>& expected) {
  ASSERT_EQ(corners.size(), expected.size());
  for (size_t i = 0; i < corners.size(); ++i) EXPECT_LE(glm::distance(corners[i], expected[i]), 1e-6) << i;
}

TEST_F(Gltf, JointsMoveVerticesAndTheNodeDoesNot) {
  Skinned skinned;
  expectCorners(worldCorners(load(skinned.asset.whole()), 0), {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}});
  // Joint 1 rotated by a quarter about x = 2: corner 2, at (-2, 2, 0) from there, would move to (-2, -2, 0).
  skinned.asset.json["nodes"][2]["rotation"] = {0, 0, std::sqrt(0.5), std::sqrt(0.5)};
  Scene scene = load(skinned.asset.whole());
  EXPECT_TRUE(scene.warnings.empty());
  expectCorners(worldCorners(scene, 0), {{0, 0, 0}, {2, 0, 0}, {0, 0, 0}});
  // Normals rotate with their vertices.
  const Pose pose = Poser(scene, -1).at(0);
  for (const BentVertex& vertex : bentVertices(scene, instancesOf(scene)[0], pose.bends[0]))
    EXPECT_LE(glm::distance(vertex.normal, dvec3(0, 0, 1)), 1e-7);
}

TEST_F(Gltf, AllSetsOfJointsCount) {
  Skinned skinned;
  int more = skinned.asset.add<uint16_t>({1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4", 4, 5123);
  int shares = skinned.asset.add<uint8_t>({255, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4", 4, 5121, true);
  skinned.attributes()["JOINTS_1"] = more;
  skinned.attributes()["WEIGHTS_1"] = shares;
  skinned.asset.json["nodes"][2]["translation"] = {2, 0, 8};
  // Corner 0 has weight 1 for each joint: half of each after normalisation.
  expectCorners(worldCorners(load(skinned.asset.whole()), 0), {{0, 0, 4}, {2, 0, 8}, {0, 2, 4}});
}

// Mirroring the skin's node flips the front face and does not move the vertices.
TEST_F(Gltf, NodeOfASkinDecidesTheFrontFace) {
  Skinned skinned;
  skinned.asset.json["nodes"][0]["scale"] = {-1, 1, 1};
  Scene scene = load(skinned.asset.whole());
  EXPECT_LT(glm::determinant(Poser(scene, -1).at(0).world_from_instance[0]), 0);
  expectCorners(worldCorners(scene, 0), {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}});
}

TEST_F(Gltf, OneJointMovesAMeshAsAWhole) {
  Skinned skinned;
  skinned.attributes()["JOINTS_0"] = skinned.asset.add<uint8_t>({1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0}, "VEC4", 4, 5121);
  skinned.asset.json["nodes"][2]["translation"] = {2, 3, 0};
  Scene scene = load(skinned.asset.whole());
  EXPECT_FALSE(bends(scene, instancesOf(scene)[0]));
  const Pose pose = Poser(scene, -1).at(0);
  const dvec4 corner(scene.meshes[0].geometries[0].vertices[1].position, 1);
  EXPECT_LE(glm::distance(dvec3(pose.world_from_instance[0] * corner), dvec3(2, 3, 0)), 1e-6);
  // If joint and node have opposite handedness, the mesh is deformed with the node's handedness.
  skinned.asset.json["nodes"][0]["scale"] = {-1, 1, 1};
  scene = load(skinned.asset.whole());
  EXPECT_TRUE(bends(scene, instancesOf(scene)[0]));
}

// A triangle with two targets: the first moves corner 1 by y = 4, the second all corners by z = 1.
struct Morphed : Skinned {
  Morphed() {
    asset.json["nodes"] = Json::parse(R"([{"mesh":0}])");
    asset.json["scenes"][0]["nodes"] = {0};
    asset.json.erase("skins");
    for (const char* gone : {"JOINTS_0", "WEIGHTS_0"}) attributes().erase(gone);
    int one = asset.add<float>({0, 0, 0, 0, 4, 0, 0, 0, 0}, "VEC3", 3, 5126);
    int all = asset.add<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 3, 5126);
    int turned = asset.add<float>({0, 1, 0, 0, 1, 0, 0, 1, 0}, "VEC3", 3, 5126);
    asset.primitive()["targets"] = Json::array({{{"POSITION", one}}, {{"POSITION", all}, {"NORMAL", turned}}});
  }
};

TEST_F(Gltf, NodeWeightsOverrideMeshWeights) {
  Morphed morphed;
  Scene scene = load(morphed.asset.whole());
  EXPECT_FALSE(bends(scene, instancesOf(scene)[0])) << "weights are 0 and not animated";
  morphed.asset.json["meshes"][0]["weights"] = {0.5, 2};
  scene = load(morphed.asset.whole());
  expectCorners(worldCorners(scene, 0), {{0, 0, 2}, {2, 2, 2}, {0, 2, 2}});
  const Pose pose = Poser(scene, -1).at(0);
  for (const BentVertex& vertex : bentVertices(scene, instancesOf(scene)[0], pose.bends[0]))
    EXPECT_LE(glm::distance(vertex.normal, glm::normalize(dvec3(0, 2, 1))), 1e-7);
  morphed.asset.json["nodes"][0]["weights"] = {0, -1};
  expectCorners(worldCorners(load(morphed.asset.whole()), 0), {{0, 0, -1}, {2, 0, -1}, {0, 2, -1}});
}

TEST_F(Gltf, MorphsApplyBeforeJoints) {
  Skinned skinned;
  int one = skinned.asset.add<float>({0, 0, 0, 0, 4, 0, 0, 0, 0}, "VEC3", 3, 5126);
  skinned.asset.primitive()["targets"] = Json::array({{{"POSITION", one}}});
  skinned.asset.json["meshes"][0]["weights"] = {1};
  skinned.asset.json["nodes"][2]["rotation"] = {0, 0, std::sqrt(0.5), std::sqrt(0.5)};
  expectCorners(worldCorners(load(skinned.asset.whole()), 0), {{0, 0, 0}, {-2, 0, 0}, {0, 0, 0}});
}

TEST_F(Gltf, MorphsWithoutNormalsHaveFacetNormals) {
  Morphed morphed;
  morphed.attributes().erase("NORMAL");
  for (Json& target : morphed.asset.primitive()["targets"]) target.erase("NORMAL");
  morphed.asset.json["meshes"][0]["weights"] = {1, 0};
  Scene scene = load(morphed.asset.whole());
  expectCorners(worldCorners(scene, 0), {{0, 0, 0}, {2, 4, 0}, {0, 2, 0}});
  const Pose pose = Poser(scene, -1).at(0);
  for (const BentVertex& vertex : bentVertices(scene, instancesOf(scene)[0], pose.bends[0]))
    EXPECT_EQ(vertex.normal, dvec3(0));
}

TEST_F(Gltf, WeightsAreInterpolated) {
  const Json path = {{"node", 0}, {"path", "weights"}};
  auto heightAt = [&](const char* how, const std::vector<float>& values, double time_s) {
    Morphed morphed;
    morphed.drive(path, values, "SCALAR", 1, how);
    return worldCorners(load(morphed.asset.whole()), time_s).at(1);
  };
  EXPECT_LE(glm::distance(heightAt("LINEAR", {0, 0, 1, 2}, 0.25), dvec3(2, 1, 0.5)), 1e-6);
  EXPECT_LE(glm::distance(heightAt("STEP", {0, 0, 1, 2}, 0.75), dvec3(2, 0, 0)), 1e-6);
  EXPECT_LE(glm::distance(heightAt("STEP", {0, 0, 1, 2}, 1), dvec3(2, 4, 2)), 1e-6);
  // In-tangents, values and out-tangents of two weights; the first has an out-tangent of 1, which adds t(1-t)^2.
  const std::vector<float> cubic = {0, 0, 0, 0, 1, 0, 0, 0, 0, 2, 0, 0};
  EXPECT_LE(glm::distance(heightAt("CUBICSPLINE", cubic, 0.5), dvec3(2, 4 * 0.125, 1)), 1e-6);
  // Within a frame a step keeps its value at the raster time.
  Morphed morphed;
  morphed.drive(path, {0, 0, 1, 2}, "SCALAR", 1, "STEP");
  Scene scene = load(morphed.asset.whole());
  EXPECT_EQ(worldCorners(scene, 1.5, 0.5), worldCorners(scene, 0.5));
}

TEST_F(Gltf, PointersDriveWeights) {
  auto at = [&](const std::string& pointer, const std::vector<float>& values) {
    Morphed morphed;
    morphed.drive({{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", pointer}}}}}}, values,
                  "SCALAR", 1);
    morphed.asset.json["extensionsUsed"] = {"KHR_animation_pointer"};
    Scene scene = load(morphed.asset.whole());
    EXPECT_TRUE(scene.warnings.empty()) << pointer;
    return worldCorners(scene, 0.5).at(1);
  };
  EXPECT_LE(glm::distance(at("/nodes/0/weights", {0, 0, 1, 2}), dvec3(2, 2, 1)), 1e-6);
  EXPECT_LE(glm::distance(at("/meshes/0/weights", {0, 0, 1, 2}), dvec3(2, 2, 1)), 1e-6);
  EXPECT_LE(glm::distance(at("/nodes/0/weights/1", {0, 6}), dvec3(2, 0, 3)), 1e-6);
  EXPECT_LE(glm::distance(at("/meshes/0/weights/0", {0, 1}), dvec3(2, 2, 0)), 1e-6);
  for (const char* nothing : {"/nodes/7/weights", "/meshes/0/weights/2", "/nodes/0/weights/9"}) {
    Morphed morphed;
    morphed.drive({{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", nothing}}}}}}, {0, 1},
                  "SCALAR", 1);
    EXPECT_NE(failure(morphed.asset.whole()).find("does not exist"), std::string::npos) << nothing;
  }
}

// ---- Facts

Facts factsAt(Scene scene, double raster_s) {
  scene.cameras.resize(1);
  scene.nodes.push_back({});
  scene.nodes.back().camera = 0;
  FrameView view;
  view.raster_s = view.close_s = raster_s;
  view.open_s = raster_s - 0.02;
  view.previous_s = raster_s - 0.04;
  return factsOf(FramePoser(scene, int(scene.nodes.size()) - 1, "all", view));
}

TEST_F(Gltf, DeformedMeshMovesWithJointsAndWeights) {
  Skinned skinned;
  skinned.drive({{"node", 2}, {"path", "translation"}}, {2, 0, 0, 2, 1, 0}, "VEC3", 3);
  Scene scene = load(skinned.asset.whole());
  EXPECT_TRUE(factsAt(scene, 0.5).moves.at(0));
  EXPECT_TRUE(factsAt(scene, 0.5).deforms);
  EXPECT_FALSE(factsAt(scene, 0).moves.at(0)) << "before the clip's keys";
  // Motion of the skin's node has no effect.
  skinned.drive({{"node", 0}, {"path", "translation"}}, {0, 0, 0, 9, 9, 9}, "VEC3", 3);
  EXPECT_FALSE(factsAt(load(skinned.asset.whole()), 0.5).motion);
  for (const char* how : {"LINEAR", "STEP"}) {
    Morphed morphed;
    morphed.drive({{"node", 0}, {"path", "weights"}}, {0, 0, 0, 1}, "SCALAR", 1, how);
    EXPECT_EQ(factsAt(load(morphed.asset.whole()), 0.5).moves.at(0), std::string(how) == "LINEAR");
    EXPECT_TRUE(factsAt(load(morphed.asset.whole()), 0.5).deforms);
  }
  EXPECT_FALSE(factsAt(load(triangle().whole()), 0).deforms);
}

// ---- Bounds

// Boxes contain the vertices at every pose.
TEST_F(Gltf, HullsContainDeformedVertices) {
  Skinned skinned;
  int one = skinned.asset.add<float>({0, 0, 0, 0, 4, 0, -3, 0, 1}, "VEC3", 3, 5126);
  skinned.asset.primitive()["targets"] = Json::array({{{"POSITION", one}}});
  skinned.asset.json["meshes"][0]["weights"] = {-0.7};
  skinned.drive({{"node", 2}, {"path", "rotation"}}, {0, 0, 0, 1, 0, 1, 0, 0}, "VEC4", 4);
  Scene scene = load(skinned.asset.whole());
  const std::vector<Instance> instances = instancesOf(scene);
  const Hull hull(scene, instances[0]);
  EXPECT_EQ(hull.boxes(), 2u);
  for (double time_s = 0; time_s <= 1; time_s += 0.1) {
    const Pose pose = Poser(scene, -1).at(time_s);
    Bounds around;
    for (size_t box = 0; box < hull.boxes(); ++box)
      for (const dvec3& corner : hull.corners(pose, 0, box)) around.add(corner);
    const Bounds posed = posedBounds(scene, instances, 0, pose);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LE(around.low[axis], posed.low[axis] + 1e-12) << time_s;
      EXPECT_GE(around.high[axis], posed.high[axis] - 1e-12) << time_s;
    }
  }
}

TEST_F(Gltf, PrecomputedBoundsGiveTheSameHulls) {
  Morphed morphed;
  morphed.drive({{"node", 0}, {"path", "weights"}}, {0, 0, 1, -2}, "SCALAR", 1);
  for (Scene& scene :
       std::vector<Scene>{load(morphed.asset.whole()), load(Skinned().asset.whole()), load(triangle().whole())}) {
    const std::vector<Instance> instances = instancesOf(scene);
    const Hull each_time(scene, instances[0]);
    findBounds(scene);
    const Hull ahead(scene, instances[0]);
    ASSERT_EQ(ahead.boxes(), each_time.boxes());
    const Pose pose = Poser(scene, -1).at(0.5);
    for (size_t box = 0; box < ahead.boxes(); ++box)
      EXPECT_EQ(ahead.corners(pose, 0, box), each_time.corners(pose, 0, box));
  }
}

// ---- Damage

TEST_F(Gltf, DamagedSkinsAreRefusedWithTheirPlace) {
  Skinned whole;
  Asset& asset = whole.asset;
  EXPECT_EQ(failure(asset.whole()), "");
  int beyond = asset.add<uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 2, 0, 0}, "VEC4", 4, 5121);
  int fewer = asset.add<uint8_t>({0, 0, 0, 0, 1, 0, 0, 0}, "VEC4", 4, 5121);
  int floats = asset.add<float>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, "VEC4", 4, 5126);
  int none = asset.add<float>({1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0}, "VEC4", 4, 5126);
  int negative = asset.add<float>({1, 0, 0, 0, 1.5f, -0.5f, 0, 0, 1, 0, 0, 0}, "VEC4", 4, 5126);
  int nan = asset.add<float>({1, 0, 0, 0, NAN, 0, 0, 0, 1, 0, 0, 0}, "VEC4", 4, 5126);
  int bytes = asset.add<uint8_t>({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4", 4, 5121);
  int one_bind = asset.add<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, "MAT4", 16, 5126);
  std::vector<float> tilted(32, 0.0f), endless(32, 0.0f);
  for (size_t i = 0; i < 32; i += 5) tilted[i % 32] = 1;
  endless[0] = INFINITY;
  int not_affine = asset.add(tilted, "MAT4", 16, 5126), infinite = asset.add(endless, "MAT4", 16, 5126);
  struct Damage {
    const char* pointer;
    Json value;  // null: removed
    const char* text;
  };
  const std::string attributes = "/meshes/0/primitives/0/attributes/";
  const std::vector<Damage> damages = {
      {"JOINTS_0", beyond, "nodes[0]: meshes[0] uses joint 2, but its skin has 2 joints"},
      {"JOINTS_0", fewer, "meshes[0].primitives[0]: JOINTS_0 has 2 elements, not 3"},
      {"JOINTS_0", floats,
       "meshes[0].primitives[0]: JOINTS_0: accessors[8] is VEC4 of floats, not VEC4 of unsigned bytes"},
      {"JOINTS_0", nullptr, "meshes[0].primitives[0]: JOINTS_0 is missing"},
      {"WEIGHTS_0", nullptr, "meshes[0].primitives[0]: WEIGHTS_0 is missing"},
      {"JOINTS_2", beyond, "meshes[0].primitives[0]: JOINTS_1 is missing"},
      {"WEIGHTS_0", none, "meshes[0].primitives[0]: all weights of vertex 1 are 0"},
      {"WEIGHTS_0", negative, "meshes[0].primitives[0]: vertex 1 has a weight of -0.5"},
      {"WEIGHTS_0", nan, "meshes[0].primitives[0]: vertex 1 has a weight of nan"},
      {"WEIGHTS_0", bytes,
       "meshes[0].primitives[0]: WEIGHTS_0: accessors[12] is VEC4 of unsigned bytes, not VEC4 of floats"},
      {"/skins/0/inverseBindMatrices", one_bind, "skins[0]: has 2 joints, but only 1 inverse bind matrices"},
      {"/skins/0/inverseBindMatrices", not_affine, "skins[0]: its inverse bind matrix 1 is not affine"},
      {"/skins/0/inverseBindMatrices", infinite, "skins[0]: its inverse bind matrix 0 is not finite"},
      {"/skins/0/inverseBindMatrices", 0, "skins[0]: accessors[0]: type is 'VEC3', not MAT4"},
      {"/skins/0/joints", {1, 9}, "skins[0]: 'joints' is 9, but the file has 3 nodes"},
      {"/skins/0/joints", {1, 1}, "skins[0]: lists joint 1 twice"},
      {"/skins/0/joints", Json::array(), "skins[0]: has no joints"},
      {"/skins/0/skeleton", 5, "skins[0]: 'skeleton' is 5"},
      {"/nodes/0/skin", 1, "nodes[0]: 'skin' is 1"},
      {"/nodes/1/skin", 0, "nodes[1]: has skin but no mesh"},
  };
  for (const Damage& damage : damages) {
    Json json = asset.whole();
    std::string path = damage.pointer;
    if (path[0] != '/') path = attributes + path;
    Json::json_pointer at(path);
    if (damage.value.is_null()) json.at(at.parent_pointer()).erase(at.back());
    else json[at] = damage.value;
    EXPECT_NE(failure(json).find(damage.text), std::string::npos) << path << ": " << failure(json);
  }
  Json json = asset.whole();
  for (const char* gone : {"JOINTS_0", "WEIGHTS_0"}) json["meshes"][0]["primitives"][0]["attributes"].erase(gone);
  EXPECT_NE(failure(json).find("nodes[0]: has a skin, but meshes[0] has no joints"), std::string::npos)
      << failure(json);
}

TEST_F(Gltf, DamagedMorphsAreRefusedWithTheirPlace) {
  Morphed whole;
  whole.asset.json["meshes"][0]["weights"] = {0.5, 2};
  int fewer = whole.asset.add<float>({0, 0, 0, 0, 4, 0}, "VEC3", 3, 5126);
  int nan = whole.asset.add<float>({0, 0, 0, 0, NAN, 0, 0, 0, 0}, "VEC3", 3, 5126);
  struct Damage {
    const char* pointer;
    Json value;
    const char* text;
  };
  const std::string targets = "meshes[0].primitives[0].targets[0]: ";
  for (const Damage& damage : std::vector<Damage>{
           {"/meshes/0/primitives/0/targets/0/POSITION", fewer, "targets[0]: POSITION has 2 elements, not 3"},
           {"/meshes/0/primitives/0/targets/0/POSITION", 99, "targets[0]: 'POSITION' is 99"},
           {"/meshes/0/primitives/0/targets/0/POSITION", nan, "targets[0]: POSITION 1 is not finite"},
           {"/meshes/0/primitives/0/targets/0/TANGENT", 0,
            "targets[0]: changes TANGENT, which is not an attribute of the primitive"},
           {"/meshes/0/primitives/0/targets/0", 3, "targets[0]: is not an object"},
           {"/meshes/0/weights", {1}, "meshes[0]: 'weights' does not have 2 numbers"},
           {"/nodes/0/weights", {1, 2, 3}, "nodes[0]: 'weights' does not have 2 numbers"},
           {"/nodes/0/weights", {1, "x"}, "nodes[0].weights[1]: 'weights' is not a number"}}) {
    Json json = whole.asset.whole();
    json[Json::json_pointer(damage.pointer)] = damage.value;
    EXPECT_NE(failure(json).find(damage.text), std::string::npos) << damage.pointer << ": " << failure(json);
  }
  Json json = whole.asset.whole();
  json["meshes"][0]["primitives"].push_back(json["meshes"][0]["primitives"][0]);
  json["meshes"][0]["primitives"][1].erase("targets");
  EXPECT_NE(failure(json).find("meshes[0]: its primitives have different numbers of morph targets"), std::string::npos);
  whole.drive({{"node", 0}, {"path", "weights"}}, {0, 0, 1}, "SCALAR", 1);
  EXPECT_NE(failure(whole.asset.whole()).find("channels[0]: 2 keys need 4 values, not 3"), std::string::npos);
  Skinned rigid;
  rigid.drive({{"node", 0}, {"path", "weights"}}, {0, 1}, "SCALAR", 1);
  EXPECT_NE(failure(rigid.asset.whole()).find("channels[0]: drives weights of node 0, which has no weights"),
            std::string::npos);
}

}  // namespace gltf_skin_test
}  // namespace strobe::scene
