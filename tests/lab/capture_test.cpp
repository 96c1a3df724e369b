// SPDX-License-Identifier: MIT
// Layers of a picture in an OpenEXR file have the device's values.
#include "lab/capture.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <filesystem>

#include "common/refusal.h"
#include "common/temporary_folder.h"
#include "lab/record.h"
#include "lab/session.h"
#include "oracle/render.h"

using namespace strobe;
using namespace strobe::lab;

namespace capture_test {

class CaptureTest : public oracle::RenderTest {
 protected:
  // The picture with every port of the plan tapped.
  static Picture everything(const Shot& shot) {
    Session session(bench(), shot);
    session.tap(session.ports());
    return session.capture();
  }
};

// The file after writing and reading.
image::ExrFile readBack(const image::ExrFile& written) {
  const Path file = strobe::testing::processFolder() / "capture.exr";
  image::writeExr(file, written);
  return image::readExr(file);
}

Shot crowd(const std::string& pipeline, const std::vector<std::string>& settings = {}) {
  return oracle::with(oracle::shotOf("crowd", 64, 40), pipeline, settings);
}

std::set<std::string> channelsOf(const image::ExrPart& part) {
  std::set<std::string> names;
  for (const auto& channel : part.channels) names.insert(channel.name);
  return names;
}

// Formats of all kinds and sizes: half floats, bytes, tile images, integers.
TEST_F(CaptureTest, TapsRoundTripBitForBit) {
  for (const char* pipeline : {"hybrid", "hybrid_layered"}) {
    Picture picture = everything(crowd(pipeline, {"velocity_format=fp16"}));
    image::ExrFile written = exrOf(picture, {.multipart = true});
    EXPECT_EQ(written.width, 64);
    auto images = imagesOf(readBack(written), "taps.exr");
    ASSERT_EQ(images.size(), picture.frame.taps.size() + picture.frame.outputs.size());
    std::set<std::string> formats, sizes;
    for (const auto& [name, read] : picture.frame.taps) {
      EXPECT_EQ(hashOf(images.at(name)), hashOf(read)) << name;
      EXPECT_EQ(images.at(name).format, read.format) << name;
      formats.insert(read.format), sizes.insert(fmt::format("{}x{}", read.floats.width, read.floats.height));
    }
    EXPECT_GE(formats.size(), 4u);
    EXPECT_GE(sizes.size(), 2u);
    EXPECT_TRUE(formats.count("rg16f") && formats.count("rg32ui")) << fmt::format("{}", fmt::join(formats, " "));
  }
}

// The mean of several samples of a half float needs more than 16 bits.
TEST_F(CaptureTest, MeansOfHalfFloatsAreNotRounded) {
  Shot shot = crowd("none", {"gbuffer.velocity_format=fp16"});
  shot.aa = 3;
  Picture picture = everything(shot);
  auto images = imagesOf(readBack(exrOf(picture, {.multipart = true})), "taps.exr");
  for (const auto& [name, read] : picture.frame.taps) EXPECT_EQ(hashOf(images.at(name)), hashOf(read)) << name;
}

TEST_F(CaptureTest, PartsKeepImagesOfAnotherSize) {
  Shot shot = crowd("mcguire2012");
  shot.taps = {"neighbour_max.dominant", "gbuffer.depth"};
  Picture picture = render(shot);
  ::testing::internal::CaptureStderr();
  image::ExrFile single = exrOf(picture);
  std::string warning = ::testing::internal::GetCapturedStderr();
  EXPECT_NE(warning.find("'neighbour_max.dominant' is"), std::string::npos) << warning;
  EXPECT_NE(warning.find("--multipart keeps it"), std::string::npos) << warning;
  EXPECT_EQ(single.find("neighbour_max.dominant.X"), nullptr);
  for (const char* wanted : {"R", "A", "Z", "N.X", "velocity.Y", "id", "geometry", "gbuffer.depth.Y"})
    EXPECT_NE(single.find(wanted), nullptr) << wanted;

  ::testing::internal::CaptureStderr();
  image::ExrFile several = readBack(exrOf(picture, {.multipart = true}));
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(several.name, "color");
  EXPECT_EQ(channelsOf(several), (std::set<std::string>{"A", "B", "G", "R"}));
  ASSERT_NE(several.part("neighbour_max.dominant"), nullptr);
  EXPECT_LT(several.part("neighbour_max.dominant")->width, 64);
  EXPECT_EQ(channelsOf(*several.part("normal")), (std::set<std::string>{"N.W", "N.X", "N.Y", "N.Z"}));
  EXPECT_EQ(channelsOf(*several.part("depth")), (std::set<std::string>{"Z"}));
  EXPECT_EQ(several.texts.at("strobe"), picture.record.dump());
  auto images = imagesOf(several, "picture.exr");
  for (const char* kind : {"outputs", "taps"})
    for (const auto& [name, hash] : picture.record[kind].items())
      EXPECT_EQ(Json(hashOf(images.at(name))), hash) << name;
  EXPECT_THROW(imagesOf(single, "single.exr"), Error);
}

// The largest half float is 65504 (IEEE 754 binary16); infinite depth is also stored as a half.
TEST_F(CaptureTest, HalvesAreClampedAndCounted) {
  Picture picture = render(crowd("none"));
  auto& colour = picture.frame.outputs.at("color").floats;
  auto& depth = picture.frame.outputs.at("depth").floats;
  colour.at(3, 4, 0) = 1e6f, colour.at(3, 4, 1) = -65505, colour.at(3, 4, 2) = 65504;
  depth.at(0, 0, 0) = INFINITY;
  for (bool multipart : {false, true}) {
    ::testing::internal::CaptureStderr();
    image::ExrFile written = exrOf(picture, {.half = true, .multipart = multipart});
    std::string said = ::testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find("2 values are beyond 65504; the file stores them as 65504"), std::string::npos) << said;
    EXPECT_NE(Json::parse(written.texts.at("strobe"))["warnings"].dump().find("beyond 65504"), std::string::npos);
    image::ExrFile read = readBack(written);
    const size_t pixel = size_t(4 * colour.width + 3);
    EXPECT_EQ(read.find("R")->values[pixel], 65504);
    EXPECT_EQ(read.find("G")->values[pixel], -65504);
    EXPECT_EQ(read.find("B")->values[pixel], 65504);
    EXPECT_TRUE(std::isinf((multipart ? read.part("depth") : &read)->find("Z")->values[0]));
  }
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(readBack(exrOf(picture)).find("R")->values[size_t(4 * colour.width + 3)], 1e6f);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST_F(CaptureTest, LayersAreSelectable) {
  Picture picture = render(crowd("none"));
  EXPECT_EQ(channelsOf(exrOf(picture, {.layers = {"depth"}})), (std::set<std::string>{"A", "B", "G", "R", "Z"}));
  image::ExrFile several = exrOf(picture, {.multipart = true, .layers = {"velocity"}});
  ASSERT_EQ(several.parts().size(), 2u);
  EXPECT_EQ(several.further[0].name, "velocity");
  const std::string refused = strobe::testing::refusalOf([&] { exrOf(picture, {.layers = {"dept"}}); });
  EXPECT_NE(refused.find("did you mean 'depth'?"), std::string::npos) << refused;
}

TEST_F(CaptureTest, IdsHaveNames) {
  Picture picture = render(crowd("none"));
  Json names = Json::parse(exrOf(picture).texts.at("strobeIds"));
  std::set<std::string> nodes;
  uint32_t last = 0;
  for (const Json& name : names) {
    EXPECT_EQ(name["first"], last + 1);
    last = name["last"];
    nodes.insert(name["node"]);
    EXPECT_FALSE(name["materials"].empty());
  }
  EXPECT_TRUE(nodes.count("wall")) << names.dump();
  const image::UintImage& ids = picture.frame.outputs.at("id").uints;
  for (int y = 0; y < ids.height; ++y)
    for (int x = 0; x < ids.width; ++x) EXPECT_LE(ids.at(x, y, 0), last);
}

// A bar with vertical edges: a sample's y does not matter. The samples of a pixel along x are the pixel centres of a
// wider picture.
TEST_F(CaptureTest, MattesAreSampleShares) {
  constexpr int kSamples = 4;
  auto bar = [](int scale) {
    return oracle::with(
        oracle::shotOf("bar", 32 * scale, 8 * scale, {{"left", 9.4 * scale}, {"right", 20.15 * scale}, {"d_f", 0}}),
        "none");
  };
  Shot shot = bar(1);
  shot.aa = kSamples;
  Picture picture = bench().render(shot, {}, true), fine = render(bar(kSamples));
  EXPECT_EQ(picture.record.dump(), render(shot).record.dump());
  image::ExrFile file = exrOf(picture, {.half = true, .cryptomatte = true});
  const uint32_t bar_id = image::cryptomatteId("bar");
  const image::UintImage& ids = fine.frame.outputs.at("id").uints;
  int partial = 0;
  for (int x = 0; x < 32; ++x) {
    int inside = 0;
    for (int i = 0; i < kSamples; ++i)
      inside += nodeOf(fine.id_names, ids.at(kSamples * x + i, 4 * kSamples, 0)) == "bar";
    size_t pixel = size_t(4 * 32 + x);
    float found = 0;
    for (const char* rank : {"RG", "BA"}) {
      const auto* id = file.find(std::string("CryptoObject00.") + rank[0]);
      const auto* share = file.find(std::string("CryptoObject00.") + rank[1]);
      EXPECT_EQ(id->kind, image::ExrKind::real);
      if (std::bit_cast<uint32_t>(id->values[pixel]) == bar_id) found += share->values[pixel];
    }
    EXPECT_EQ(found, float(inside) / kSamples) << x;
    EXPECT_EQ(file.find("coverage.Y")->values[pixel], 1) << x;
    partial += inside > 0 && inside < kSamples;
  }
  EXPECT_EQ(partial, 2);
}

TEST_F(CaptureTest, MattesNeedIds) {
  Picture picture = render(crowd("none"));
  EXPECT_NE(exrOf(picture, {.cryptomatte = true}).find("CryptoMaterial02.A"), nullptr);
  image::ExrFile several = exrOf(picture, {.multipart = true, .cryptomatte = true});
  ASSERT_NE(several.part("CryptoObject"), nullptr);
  EXPECT_EQ(channelsOf(*several.part("CryptoObject")).size(), 12u);
  EXPECT_EQ(several.part("CryptoObject")->texts.size(), 4u);
  picture.frame.outputs.erase("id");
  EXPECT_THROW(exrOf(picture, {.cryptomatte = true}), Error);
}

}  // namespace capture_test
