// SPDX-License-Identifier: MIT
// Deformation by joints and morph targets. The result is equal for every ray tracing backend and for truth with skipped
// rays. Vertices without a moving joint are exactly static, and scenes without deformation lack the fact `deforms`.
#include <fmt/format.h>

#include <set>

#include "common/home.h"
#include "common/source.h"
#include "oracle/render.h"
#include "scene/bend.h"

namespace strobe::oracle {
namespace render_bending_test {

namespace fs = std::filesystem;

class RenderBending : public RenderTest {
 protected:
  void SetUp() override {
    std::optional<Path> data = home().data();
    if (!data || !fs::exists(*data / "scenes/khronos_samples/CesiumMan.glb"))
      GTEST_SKIP() << "no shared scenes (set STROBE_DATA)";
  }

  static lab::Shot sample(const std::string& name, int frame) {
    lab::Shot shot;
    shot.scene = *home().data() / "scenes/khronos_samples" / (name + ".glb");
    shot.width = 64;
    shot.height = 40;
    shot.fps = 12;
    shot.frame = frame;
    shot.anchor = "centre";
    return shot;
  }

  static std::vector<lab::Shot> samples() {
    return {sample("CesiumMan", 6), sample("RiggedSimple", 9), sample("AnimatedMorphSphere", 30)};
  }

  static lab::Picture by(lab::Shot shot, const std::string& backend) {
    shot.backend = backend;
    return render(shot);
  }
};

TEST_F(RenderBending, BackendsGiveTheSamePictures) {
  for (const lab::Shot& shot : samples())
    for (const lab::Shot& drawn : {with(shot, "none"), with(shot, "hybrid_layered", {"tile=8", "limit=0.25"}),
                                   with(shot, "hybrid", {"tile=8", "limit=0.25"}),
                                   with(shot, "ground_truth", {"samples=12", "times=stratified", "slices=4"})}) {
      const Json first = by(drawn, backends().front()).record["outputs"];
      for (const std::string& backend : backends())
        EXPECT_EQ(by(drawn, backend).record["outputs"], first)
            << shot.scene << ", " << drawn.pipeline << ", " << backend;
    }
}

// Truth skips only rays with a known result: the picture is bit for bit the picture of all rays.
TEST_F(RenderBending, SkippedRaysDoNotChangeTruth) {
  for (const lab::Shot& shot : samples())
    for (const std::string& backend : backends()) {
      lab::Picture spared = by(with(shot, "ground_truth", {"samples=12"}), backend);
      lab::Picture all = by(with(shot, "ground_truth", {"samples=12", "mode=brute"}), backend);
      for (const char* output : {"color", "error", "inner", "outer"})
        EXPECT_TRUE(identical(imageOf(spared, output), imageOf(all, output)))
            << shot.scene << ", " << backend << ", " << output;
    }
}

// Without animation a deformable scene is static to the last bit, also if everything is modelled.
TEST_F(RenderBending, ScenesAreStaticWithoutTheirAnimation) {
  for (lab::Shot shot : samples()) {
    shot.animation = "none";
    lab::Shot two = with(shot, sourceFolder() / "tests/oracle/pipelines/two_ways.lua");
    lab::Picture picture = render(two);
    EXPECT_EQ(rms(imageOf(picture, "velocity")), 0) << shot.scene;
    EXPECT_EQ(rms(imageOf(picture, "ray_velocity")), 0) << shot.scene;
    two.model_everything = true;  // displacements are computed, from equal poses
    picture = render(two);
    EXPECT_EQ(rms(imageOf(picture, "velocity")), 0) << shot.scene;
    EXPECT_EQ(rms(imageOf(picture, "ray_velocity")), 0) << shot.scene;
    EXPECT_TRUE(identical(colorOf(render(with(shot, "none"))), colorOf(render(with(shot, "hybrid"))))) << shot.scene;
  }
}

// One leg moves. Vertices that follow none of its joints are static to the last bit.
TEST_F(RenderBending, VerticesWithoutAMovingJointAreStatic) {
  lab::Shot shot = with(sample("CesiumMan", 0), sourceFolder() / "tests/oracle/pipelines/two_ways.lua");
  shot.animation = "none";
  shot.width = 160;
  shot.height = 100;
  shot.moves = {"leg_joint_L_2=0,0.02,0.01"};
  std::shared_ptr<lab::HeldScene> held = bench().scene(shot);
  const scene::Scene& scene = held->scene;
  const scene::Skin& skin = scene.skins.at(0);
  std::set<uint32_t> moving;
  for (size_t j = 0; j < skin.joints.size(); ++j)
    for (int node = skin.joints[j]; node >= 0; node = scene.nodes[size_t(node)].parent)
      if (scene.nodes[size_t(node)].name == "leg_joint_L_2") moving.insert(uint32_t(j));
  ASSERT_FALSE(moving.empty());
  const scene::Geometry& geometry = scene.meshes.at(0).geometries.at(0);
  auto follows = [&](uint32_t vertex) {
    for (size_t k = vertex * 4; k < vertex * 4 + 4; ++k)
      if (geometry.influences.shares[k] != 0 && moving.count(geometry.influences.joints[k])) return true;
    return false;
  };
  lab::Picture picture = render(shot);
  const image::UintImage& hit = picture.frame.outputs.at("hit").uints;
  const image::Image& velocity = imageOf(picture, "velocity");
  int still = 0, moved = 0;
  for (int y = 0; y < shot.height; ++y)
    for (int x = 0; x < shot.width; ++x) {
      if (hit.at(x, y, 0) == 0) continue;
      bool any = false;
      for (uint32_t c = 0; c < 3; ++c) any = any || follows(geometry.indices[3 * hit.at(x, y, 2) + c]);
      const double length = std::hypot(velocity.at(x, y, 0), velocity.at(x, y, 1));
      if (!any) EXPECT_EQ(length, 0) << x << ", " << y;
      ++(any ? moved : still);
      if (any) EXPECT_GT(length, 0) << x << ", " << y;
    }
  EXPECT_GT(still, 200);
  EXPECT_GT(moved, 20);
}

// `--move` of the node that holds a skin moves the skin, although joints define its position.
TEST_F(RenderBending, SkinNodesCanBeMoved) {
  lab::Shot shot = with(sample("RiggedSimple", 0), sourceFolder() / "tests/oracle/pipelines/two_ways.lua");
  shot.animation = "none";
  auto held = bench().scene(shot);
  const scene::Scene& scene = held->scene;
  shot.moves = {scene.nodes[size_t(scene::instancesOf(scene).at(0).node)].name + "=0.5,0,0"};
  lab::Picture picture = render(shot);
  const image::UintImage& hit = picture.frame.outputs.at("hit").uints;
  const image::Image& velocity = imageOf(picture, "velocity");
  for (int y = 0; y < shot.height; ++y)
    for (int x = 0; x < shot.width; ++x)
      if (hit.at(x, y, 0) != 0) EXPECT_GT(velocity.at(x, y, 0), 0.1) << x << ", " << y;
}

// Only scenes with deformation have the fact `deforms`.
TEST_F(RenderBending, DeformationIsAFactOfTheScene) {
  auto holds = [](const lab::Picture& picture) {
    const Json& facts = picture.record["facts"];
    return std::count(facts.begin(), facts.end(), Json("deforms")) > 0;
  };
  EXPECT_TRUE(holds(render(with(samples()[0], "none"))));
  EXPECT_FALSE(holds(render(with(sample("BoxAnimated", 6), "none"))));
}

// Parts that follow one joint are rigid: the blades and the base of the fan, not the cage.
TEST_F(RenderBending, PartsOfOneJointAreRigid) {
  lab::Shot shot = sample("", 0);
  shot.scene = *home().data() / "scenes/vintage_desk_fan/vintage_desk_fan.glb";
  if (!fs::exists(shot.scene)) GTEST_SKIP() << "no fan";
  auto held = bench().scene(shot);
  const scene::Scene& scene = held->scene;
  int skinned = 0, bending = 0;
  for (const scene::Instance& instance : scene::instancesOf(scene)) {
    skinned += scene.nodes[size_t(instance.node)].skin >= 0;
    bending += scene::bends(scene, instance);
  }
  EXPECT_EQ(skinned, 3);
  EXPECT_EQ(bending, 1);
}

}  // namespace render_bending_test
}  // namespace strobe::oracle
