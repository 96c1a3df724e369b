// SPDX-License-Identifier: MIT
// Pipelines on two drivers without common code: a capture of the software device, verified on SwiftShader from Debian's
// Chromium. SwiftShader snaps vertices to 1/16 px (here 1/256), has coarser texture filters, and lacks acceleration
// structures and geometry shaders. Finds results that depend on one driver's uninitialised memory, rounding or order.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/json.h"
#include "common/all_cases.h"
#include "common/source.h"
#include "program/run.h"

namespace strobe::testing {
namespace second_driver_test {

const char* const kDriver = "/usr/lib/chromium/vk_swiftshader_icd.json";

// The scene is a card that moves in front of a checkerboard. The short form has a pipeline for each kind of pass:
// raster, gather, rays over lists, adaptive rays, truth.
std::string captureText() {
  std::vector<std::string> arms = {"none", "mcguire2012", "hybrid_layered", "adaptive"};
  if (allCases())
    for (const char* more : {"ue4", "ue5", "guertin2014", "jimenez2014", "bevy", "hdrp", "eevee", "lee2024",
                             "oberberger2022", "accumulation", "hybrid"})
      arms.push_back(more);
  std::string text = R"lua(
local capture = require "strobe.capture"
return capture {
  title = "Two drivers", size = { 64, 36 },
  shots = { { name = "card", scene = "scene.lua", move = { card = { 0.6, 0, 0 } } } },
  arms = { { name = "truth", pipeline = "ground_truth", set = { samples = 8, pixel = "box" } },
)lua";
  for (const std::string& arm : arms) text += fmt::format("    {{ name = \"{0}\", pipeline = \"{0}\" }},\n", arm);
  return text + "  },\n}\n";
}

TEST(SecondDriver, DrawsSimilarPictures) {
  if (!fs::exists(kDriver)) GTEST_SKIP() << "missing: " << kDriver;
  TemporaryFolder folder;
  writeText(folder / "scene.lua", kCardScene);
  writeText(folder / "capture.lua", captureText());
  Outcome captured = run("capture " + (folder / "capture.lua") + " -o " + (folder / "taken"), "STROBE_VALIDATION=0");
  ASSERT_EQ(captured.exit_code, 0) << captured.err;

  std::string environment = std::string("STROBE_VALIDATION=0 VK_DRIVER_FILES=") + kDriver;
  Outcome verified = run("verify " + (folder / "taken") + " --json", environment);
  ASSERT_TRUE(verified.exit_code == 0 || verified.exit_code == 1) << verified.err;
  Json json = Json::parse(verified.out, nullptr, false);
  ASSERT_TRUE(json.is_object()) << verified.out << verified.err;
  EXPECT_FALSE(json.at("same_device").get<bool>());
  ASSERT_EQ(json.at("pictures").size(), allCases() ? 16u : 5u) << verified.out;
  for (const Json& picture : json.at("pictures"))
    for (const Json& layer : picture.at("layers")) {
      std::string name = picture.at("name").get<std::string>() + " " + layer.at("image").get<std::string>();
      double pixels = layer.at("pixels").get<double>() / (64 * 36);
      RecordProperty(name, fmt::format("{:.3f} of the pixels, mean {:.2g}", pixels, layer.at("average").get<double>()));
      // Ids differ only at silhouettes, which cover other pixels.
      if (layer.at("image") == "id") EXPECT_LE(pixels, 0.05) << name;
      // The remaining difference is the filter of the checkerboard's texture: a mean FLIP of 0.0125 for each method.
      // Measured for truth: 0.036 with 8 samples spread over a pixel, and 0.028 with one ray per pixel, because a ray
      // on the other side of a silhouette decides its pixel. eevee averages pictures of four steps with different
      // silhouettes: 0.025.
      bool by_few_rays =
          name.starts_with("card.truth") || name.starts_with("card.oberberger2022") || name.starts_with("card.eevee");
      if (layer.contains("flip")) EXPECT_LE(layer.at("flip").get<double>(), by_few_rays ? 0.05 : 0.02) << name;
    }
}

}  // namespace second_driver_test
}  // namespace strobe::testing
