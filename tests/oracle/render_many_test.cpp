// SPDX-License-Identifier: MIT
// A scene of many small meshes and textures against its closed form: squares of two by two pixels, one colour each, in
// rows that cover the picture.
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>

#include "image/png.h"
#include "image/tone.h"
#include "oracle/render.h"
#include "scene/gltf_asset.h"

namespace strobe::oracle {
namespace render_many_test {

constexpr int kAcross = 100, kMeshes = 5000, kTextures = 1000;
constexpr int kWidth = 2 * kAcross, kHeight = 2 * kMeshes / kAcross;

std::vector<float> colorOfTexture(int texture) {
  const int column = texture % 100, row = texture / 100;
  return {float(10 + 2 * column) / 255, float(10 + 20 * row) / 255, 0.4f};
}

class RenderMany : public RenderTest {
 protected:
  void SetUp() override { scene::writeQuickly(file(), squares().dump()); }
  void TearDown() override {
    std::filesystem::remove_all(file().parent_path());
    RenderTest::TearDown();
  }

  static Path file() {
    return std::filesystem::temp_directory_path() / fmt::format("strobe_many_{}/a.gltf", ::getpid());
  }

  static void addTextures(Json& json) {
    for (int t = 0; t < kTextures; ++t) {
      image::Image texels(4, 4, 3);
      const std::vector<float> color = colorOfTexture(t);
      for (size_t i = 0; i < texels.values.size(); ++i) texels.values[i] = color[i % 3];
      const std::string png = image::encodePng(texels, image::PngEffort::fast);
      json["images"].push_back({{"uri", "data:image/png;base64," + scene::base64({png.begin(), png.end()})}});
      json["textures"].push_back({{"source", t}});
      json["materials"].push_back({{"extensions", {{"KHR_materials_unlit", Json::object()}}},
                                   {"doubleSided", true},
                                   {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", t}}}}}});
    }
  }

  static Json squares() {
    scene::Asset asset;
    asset.add<float>({0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0}, "VEC3", 3, 5126);
    asset.add<float>({0, 1, 1, 1, 1, 0, 0, 0}, "VEC2", 2, 5126);
    asset.add<uint16_t>({0, 1, 2, 0, 2, 3}, "SCALAR", 1, 5123);
    Json& json = asset.json;
    for (const char* list : {"images", "textures", "materials", "meshes", "nodes"}) json[list] = Json::array();
    addTextures(json);
    for (int i = 0; i < kMeshes; ++i) {
      const Json primitive = {
          {"attributes", {{"POSITION", 0}, {"TEXCOORD_0", 1}}}, {"indices", 2}, {"material", i % kTextures}};
      json["meshes"].push_back({{"primitives", {primitive}}});
      const int x = 2 * (i % kAcross) - kWidth / 2, y = 2 * (i / kAcross) - kHeight / 2;
      json["nodes"].push_back({{"mesh", i}, {"translation", {x, y, 0}}});
    }
    json["cameras"] = {{{"type", "orthographic"},
                        {"orthographic", {{"xmag", kWidth / 2}, {"ymag", kHeight / 2}, {"znear", 1}, {"zfar", 9}}}}};
    json["nodes"].push_back({{"camera", 0}, {"translation", {0, 0, 4}}});
    json["scenes"][0]["nodes"] = Json::array();
    for (int i = 0; i <= kMeshes; ++i) json["scenes"][0]["nodes"].push_back(i);
    return asset.whole();
  }

  static lab::Shot shot(const std::string& pipeline, const std::vector<std::string>& settings) {
    lab::Shot shot;
    shot.scene = file();
    shot.width = kWidth, shot.height = kHeight;
    shot.frame = 0;
    return with(shot, pipeline, settings);
  }

  // Largest difference from the closed form, linear radiance.
  static double errorOf(const lab::Picture& picture) {
    double most = 0;
    const image::Image& color = colorOf(picture);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const std::vector<float> wanted = colorOfTexture(((kHeight - 1 - y) / 2 * kAcross + x / 2) % kTextures);
        for (int c = 0; c < 3; ++c)
          most = std::max<double>(most, std::abs(color.at(x, y, c) - image::decodeSrgb(wanted[size_t(c)])));
      }
    return most;
  }
};

// Driver calls since the start of a test.
size_t allocations = 0, submissions = 0;
gpu::Dispatch calls_before;

// The first frame of a scene makes few allocations and few submissions for its meshes and textures.
TEST_F(RenderMany, MeshesAndTexturesShareAllocationsAndSubmissions) {
  auto& calls = const_cast<gpu::Dispatch&>(bench().device().vk());
  calls_before = calls;
  calls.AllocateMemory = [](VkDevice device, const VkMemoryAllocateInfo* info, const VkAllocationCallbacks* callbacks,
                            VkDeviceMemory* memory) {
    ++allocations;
    return calls_before.AllocateMemory(device, info, callbacks, memory);
  };
  calls.QueueSubmit2 = [](VkQueue queue, uint32_t count, const VkSubmitInfo2* infos, VkFence fence) {
    ++submissions;
    return calls_before.QueueSubmit2(queue, count, infos, fence);
  };
  std::vector<lab::Shot> shots = {shot("none", {})};
  for (const shader::BackendRow& row : shader::backends()) {
    if (!shader::isPresent(row, bench().device().info())) continue;
    shots.push_back(shot("ground_truth", {"samples=1"}));
    shots.back().backend = row.name;
  }
  for (const lab::Shot& one : shots) {
    allocations = submissions = 0;
    EXPECT_LT(errorOf(render(one)), 2e-3) << one.pipeline << " " << one.backend;
    EXPECT_LT(allocations, 40u) << one.pipeline << " " << one.backend;
    EXPECT_LT(submissions, 40u) << one.pipeline << " " << one.backend;
  }
  calls = calls_before;
}

}  // namespace render_many_test
}  // namespace strobe::oracle
