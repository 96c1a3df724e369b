// SPDX-License-Identifier: MIT
// The run record states every limit that a shot reached, and no other limit.
#include "lab/limits.h"

#include <algorithm>
#include <regex>
#include <set>

#include "common/refusal.h"
#include "common/source.h"
#include "oracle/render.h"
#include "world/fits.h"

namespace strobe::stability {
namespace limits_test {

using oracle::shotOf;
using oracle::with;

class Limits : public oracle::RenderTest {
 protected:
  static std::vector<std::string> warningsOf(const lab::Shot& shot) {
    lab::Picture picture = render(shot);
    EXPECT_EQ(picture.record["warnings"].get<std::vector<std::string>>(), picture.warnings);
    return picture.warnings;
  }
  // The only warning of a shot.
  static std::string warningOf(const lab::Shot& shot) {
    std::vector<std::string> warnings = warningsOf(shot);
    EXPECT_EQ(warnings.size(), 1u) << fmt::format("{}", fmt::join(warnings, "\n"));
    return warnings.empty() ? "" : warnings.front();
  }
};

lab::Shot crowd(const std::string& pipeline, const std::vector<std::string>& settings = {}) {
  return with(shotOf("crowd", 32, 20, {{"speed", .25}}), pipeline, settings);
}

TEST_F(Limits, OrdinaryShotReachesNone) {
  for (const char* pipeline : {"none", "mcguire2012", "hybrid_layered"})
    EXPECT_EQ(warningsOf(crowd(pipeline)), std::vector<std::string>()) << pipeline;
}

// The count is of pixels in the velocity image whose displacement exceeds limit * width.
TEST_F(Limits, ShortenedDisplacementsAreCounted) {
  lab::Picture picture = render(crowd("mcguire2012", {"limit=0.05"}));
  const image::Image& velocity = oracle::imageOf(picture, "velocity");
  int longer = 0;
  for (size_t i = 0; i < velocity.values.size(); i += 2)
    longer += std::hypot(velocity.values[i], velocity.values[i + 1]) > .05f * 32;
  ASSERT_GT(longer, 20);
  EXPECT_EQ(oracle::counterOf(picture, "tile_max.clamped"), uint64_t(longer));
  ASSERT_EQ(picture.warnings.size(), 1u);
  std::string begin = fmt::format(
      "tile_max: {} pixels (of either layer) that move farther than the limit of displacements; each", longer);
  EXPECT_TRUE(picture.warnings[0].starts_with(begin)) << picture.warnings[0];
}

TEST_F(Limits, PathsExtrapolatedFromTheNearPlaneAreReported) {
  lab::Shot shot = with(crowd("mcguire2012"), "mcguire2012", {"limit=10"}, "end");
  shot.moves = {"camera=0,0,30"};
  std::vector<std::string> warnings = warningsOf(shot);  // these paths are also too long
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_TRUE(warnings[0].starts_with("gbuffer: ")) << warnings[0];
  EXPECT_NE(warnings[0].find("behind the near plane"), std::string::npos) << warnings[0];
}

TEST_F(Limits, MotionExtrapolatedBeyondItsFrameIsReported) {
  lab::Shot shot = crowd("mcguire2012", {"displacement=extrapolated", "limit=10"});
  shot.exposure = 1;
  EXPECT_EQ(warningsOf(shot), std::vector<std::string>());
  shot.exposure = 1.5;
  EXPECT_NE(warningOf(shot).find("of more than one frame; motion outside"), std::string::npos);
}

// The clip of `bent` has keys from -8 to 8 exposures of 1/48 s each, and its end differs from its start.
TEST_F(Limits, ExposuresBeyondAClipAreReported) {
  lab::Shot shot = with(shotOf("bent", 32, 8), "none", {}, "end");
  const double exposure_s = 1. / 48;
  auto warningsAt = [&](double frames_per_second, int frame) {
    shot.fps = frames_per_second;
    shot.exposure = exposure_s * shot.fps;
    shot.frame = frame;
    return warningsOf(shot);
  };
  EXPECT_TRUE(warningsAt(24, 3).empty());
  std::vector<std::string> seam = warningsAt(1000, 170);  // 0.17 s: 8 exposures end at 0.1667 s
  ASSERT_EQ(seam.size(), 1u);
  EXPECT_NE(seam[0].find("spans the end of 'bent' at 0.166667 s; keyed values jump back"), std::string::npos)
      << seam[0];
  EXPECT_TRUE(warningsAt(1000, 160).empty());
}

// A scene of three instances with two triangles each, four vertices of 44 bytes, and a texture of 8 texels.
scene::Scene smallScene() {
  scene::Scene scene;
  scene.name = "small";
  scene.materials.emplace_back();
  scene::Mesh mesh;
  mesh.name = "square";
  mesh.geometries.push_back({std::vector<scene::Vertex>(4), {0, 1, 2, 0, 2, 3}, 0});
  scene.meshes.push_back(mesh);
  for (int i = 0; i < 3; ++i) {
    scene::Node node;
    node.mesh = 0;
    scene.nodes.push_back(node);
  }
  scene.textures.emplace_back().name = "stripe";
  scene.textures.back().width = 8;
  return scene;
}

std::string refusalOf(const gpu::DeviceLimits& limits,
                      shader::StructureKind structures = shader::StructureKind::Driver) {
  return testing::refusalOf([&] { world::requireFits(smallScene(), 4, structures, limits); });
}

TEST(DeviceLimits, AreNamedBeforeAllocation) {
  const gpu::DeviceLimits enough{
      .image_side = 8, .array_bytes = 3 * 4 * 48, .instances = 3, .geometries = 1, .triangles = 2};
  EXPECT_EQ(refusalOf(enough), "");
  auto with = [&](auto change) {
    gpu::DeviceLimits limits = enough;
    change(limits);
    return refusalOf(limits);
  };
  EXPECT_EQ(with([](auto& l) { l.instances = 2; }),
            "small: the scene has 3 instances of at most 2; nothing is drawn; merge meshes, or use another device");
  EXPECT_EQ(with([](auto& l) { l.triangles = 1; }),
            "small: mesh 'square' has 2 triangles of at most 1; nothing is drawn; split the mesh");
  EXPECT_NE(with([](auto& l) { l.geometries = 0; }).find("mesh 'square' has 1 parts of at most 0"), std::string::npos);
  EXPECT_NE(with([](auto& l) { l.image_side = 7; }).find("texture 'stripe' has 8 pixels a side of at most 7"),
            std::string::npos);
  EXPECT_NE(with([](auto& l) { l.textures = 0; }).find("the scene has 1 textures of at most 0"), std::string::npos);
  std::string bytes = with([](auto& l) { l.array_bytes = 175; });
  EXPECT_NE(bytes.find("the buffer of all vertices has 176 bytes of at most 175"), std::string::npos) << bytes;
  EXPECT_NE(bytes.find("the buffer of all transforms has 576 bytes of at most 175"), std::string::npos) << bytes;
  // The runtime's BVH has a copy of the two triangles, 48 bytes each.
  bytes = refusalOf({.array_bytes = 95}, shader::StructureKind::Own);
  EXPECT_NE(bytes.find("the buffer of all triangles of its tree has 96 bytes of at most 95"), std::string::npos)
      << bytes;
}

// Name of the constant that declares a limit, such as "kBufferLimit".
std::string constantOf(const Limit& limit, const std::string& headers) {
  std::string name(limit.name);
  std::smatch match;
  bool declared = std::regex_search(headers, match, std::regex(R"(constexpr Limit (k\w+)\{\s*")" + name + "\""));
  EXPECT_TRUE(declared) << name;
  return declared ? match[1].str() : name;
}

TEST(LimitTable, ReportedLimitsAreUsedAndKnownOnesAreNot) {
  std::string headers, sources;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(sourceFolder() / "runtime")) {
    if (entry.path().extension() == ".cpp") sources += readText(entry.path());
    if (entry.path().filename() == "limits.h") headers += readText(entry.path());
  }
  std::set<std::string_view> names;
  for (const Limit& limit : lab::allLimits()) {
    bool used = sources.find(constantOf(limit, headers)) != std::string::npos;
    EXPECT_EQ(used, limit.kind != Limit::Kind::Known) << limit.name;
    EXPECT_TRUE(names.insert(limit.name).second) << limit.name << " is declared twice";
  }
  EXPECT_GE(names.size(), 11u);
}

}  // namespace limits_test
}  // namespace strobe::stability
