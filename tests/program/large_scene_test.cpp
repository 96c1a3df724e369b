// SPDX-License-Identifier: MIT
// Vertices beyond the range of a bound buffer (128 MiB on the software device): vertices that no triangle uses do not
// change pictures.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "base/json.h"
#include "program/run.h"

namespace strobe::testing {
namespace large_scene_test {

using Corner = std::array<float, 3>;

// A pyramid that uses the last five of `vertices`; the others are at the origin and are not stored in the file.
void writePyramid(const fs::path& file, uint32_t vertices, float height) {
  const std::array<Corner, 5> corners = {{{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}, {0, height, 0}}};
  const std::array<Corner, 5> normals = {{{-1, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, 0.6f, 0.8f}}};
  std::array<uint32_t, 12> indices = {0, 4, 1, 1, 4, 2, 2, 4, 3, 3, 4, 0};
  std::array<uint32_t, 5> last;
  for (uint32_t& index : indices) index += vertices - 5;
  for (uint32_t i = 0; i < 5; ++i) last[i] = vertices - 5 + i;
  std::string bytes(12 * 4 + 5 * 4 + 2 * 5 * 12, '\0');
  std::memcpy(bytes.data(), indices.data(), 48);
  std::memcpy(bytes.data() + 48, last.data(), 20);
  std::memcpy(bytes.data() + 68, corners.data(), 60);
  std::memcpy(bytes.data() + 128, normals.data(), 60);
  writeText(fs::path(file).replace_extension(".bin"), bytes);
  auto sparse = [&](int view) {
    Json part = {
        {"count", 5}, {"indices", {{"bufferView", 1}, {"componentType", 5125}}}, {"values", {{"bufferView", view}}}};
    return Json{{"componentType", 5126}, {"type", "VEC3"}, {"count", vertices}, {"sparse", part}};
  };
  auto view = [](int at, int length) { return Json{{"buffer", 0}, {"byteOffset", at}, {"byteLength", length}}; };
  Json gltf;
  gltf["asset"]["version"] = "2.0";
  gltf["buffers"] = {{{"uri", file.stem().string() + ".bin"}, {"byteLength", bytes.size()}}};
  gltf["bufferViews"] = {view(0, 48), view(48, 20), view(68, 60), view(128, 60)};
  gltf["accessors"] = {Json{{"bufferView", 0}, {"componentType", 5125}, {"type", "SCALAR"}, {"count", 12}}, sparse(2),
                       sparse(3)};
  Json attributes = {{"POSITION", 1}, {"NORMAL", 2}};
  gltf["meshes"] = {{{"primitives", {{{"indices", 0}, {"attributes", attributes}}}}}};
  gltf["nodes"] = {{{"mesh", 0}}};
  gltf["scenes"] = {{{"nodes", {0}}}};
  writeText(file, gltf.dump());
}

// Hashes of the outputs of a pipeline for a scene.
Json outputsOf(const TemporaryFolder& folder, const std::string& scene, const std::string& pipeline) {
  Outcome outcome = run("render " + pipeline + (pipeline == "none" ? "" : " --samples 2") + " --size 64x36 --scene " +
                            (folder / scene) + " -o " + (folder / "a.exr"),
                        "STROBE_VALIDATION=1");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  if (outcome.exit_code != 0) return {};
  return Json::parse(contentOf(folder / "a.record.json")).at("outputs");
}

TEST(LargeScene, IsDrawnFromItsUsedVertices) {
  constexpr uint32_t kMany = 3100000;
  static_assert(kMany * uint64_t{44} > uint64_t{128} << 20);
  TemporaryFolder folder;
  writePyramid(folder / "small.gltf", 5, 1);
  writePyramid(folder / "other.gltf", 5, 1.1f);
  writePyramid(folder / "large.gltf", kMany, 1);
  const Json drawn = outputsOf(folder, "small.gltf", "none"), traced = outputsOf(folder, "small.gltf", "ground_truth");
  EXPECT_EQ(outputsOf(folder, "large.gltf", "none"), drawn);
  EXPECT_EQ(outputsOf(folder, "large.gltf", "ground_truth"), traced);
  EXPECT_NE(outputsOf(folder, "other.gltf", "none"), drawn);
}

}  // namespace large_scene_test
}  // namespace strobe::testing
