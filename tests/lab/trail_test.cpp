// SPDX-License-Identifier: MIT
// The trail of a pixel compared with the layers of an EXR file of the same shot and with the known surfaces.
#include "lab/trail.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <limits>

#include "common/temporary_folder.h"
#include "lab/capture.h"
#include "oracle/render.h"

using namespace strobe;
using namespace strobe::lab;

namespace trail_test {

class TrailTest : public oracle::RenderTest {
 protected:
  static void expectWhatTheFileHolds(const Shot& shot);
};

// "gbuffer.velocity" with two channels is velocity.X and .Y in a file, below the node's name.
std::vector<const image::ExrChannel*> layerOf(const image::ExrFile& file, const std::string& layer) {
  std::vector<const image::ExrChannel*> channels;
  for (const char* component : {"R", "G", "B", "A", "X", "Y", "Z", "W"})
    if (const auto* channel = file.find(layer + "." + component)) channels.push_back(channel);
  return channels;
}

bool sameBits(double value, float stored) {
  return std::bit_cast<uint32_t>(float(value)) == std::bit_cast<uint32_t>(stored);
}

// Compares each row with the file's layer at the pixel; returns the number of rows without a layer.
int compareWithFile(const Trail& trail, const image::ExrFile& file) {
  int absent = 0;
  for (const TrailRow& row : trail.rows) {
    std::vector<const image::ExrChannel*> channels = layerOf(file, row.node + "." + row.port);
    absent += channels.empty();
    if (channels.empty()) continue;
    size_t i = size_t(trail.y) * size_t(trail.width) + size_t(trail.x);
    EXPECT_EQ(channels.size(), std::max(row.values.size(), row.integers.size())) << row.node << "." << row.port;
    for (size_t c = 0; c < row.values.size(); ++c)
      EXPECT_TRUE(sameBits(row.values[c], channels[c]->values[i])) << row.node << "." << row.port;
    for (size_t c = 0; c < row.integers.size(); ++c) EXPECT_EQ(row.integers[c], channels[c]->ids[i]) << row.node;
  }
  return absent;
}

// An EXR file of the shot with all ports tapped, written and read.
image::ExrFile fileOf(const Picture& picture) {
  const Path file = strobe::testing::processFolder() / "trail.exr";
  ::testing::internal::CaptureStderr();  // reports the tile images that are left out
  image::writeExr(file, exrOf(picture));
  ::testing::internal::GetCapturedStderr();
  return image::readExr(file);
}

TrailRow rowOf(const std::string& format, std::vector<double> values) {
  TrailRow row;
  row.node = "blur", row.port = "blurred", row.format = format, row.doc = "linear";
  row.width = 64, row.height = 40;
  row.values = std::move(values);
  return row;
}

// Compares the trail of a pixel with a file of all ports; at least two tile images are not in the file.
void TrailTest::expectWhatTheFileHolds(const Shot& shot) {
  Picture alone = render(shot);
  Followed followed = follow(bench(), shot, 23, 14);
  EXPECT_EQ(followed.picture.record.dump(), alone.record.dump());
  EXPECT_TRUE(followed.picture.frame.taps.empty());
  for (const auto& [name, read] : alone.frame.outputs)
    EXPECT_TRUE(oracle::identical(read.floats, followed.picture.frame.outputs.at(name).floats)) << name;

  Shot tapped = shot;
  for (const TrailRow& row : followed.trail.rows) tapped.taps.push_back(row.node + "." + row.port);
  Picture everything = render(tapped);
  EXPECT_GE(compareWithFile(followed.trail, fileOf(everything)), 2);
  for (const TrailRow& row : followed.trail.rows) {
    const image::Image& image = everything.frame.taps.at(row.node + "." + row.port).floats;
    EXPECT_EQ(row.x, row.divide == 0 ? 0 : 23 / row.divide) << row.node;
    for (size_t c = 0; c < row.values.size(); ++c)
      EXPECT_TRUE(sameBits(row.values[c], image.at(row.x, row.y, int(c)))) << row.node << "." << row.port;
  }
}

TEST_F(TrailTest, MatchesTheFile) {
  for (const char* pipeline : {"adaptive", "mcguire2012"})
    expectWhatTheFileHolds(oracle::with(oracle::shotOf("crowd", 64, 40), pipeline));
}

// Taps given by the user stay in the picture.
TEST_F(TrailTest, KeepsTheUsersTaps) {
  Shot shot = oracle::with(oracle::shotOf("crowd", 64, 40), "mcguire2012");
  shot.taps = {"gbuffer.depth"};
  Followed followed = follow(bench(), shot, 0, 39);
  EXPECT_EQ(followed.picture.record.dump(), render(shot).record.dump());
  EXPECT_EQ(followed.picture.frame.taps.size(), 1u);
}

// Pixel 20,13 lies on the card "high", 16 m away, which moves by (9.125, 3.25) px; the wall in the background, 32 m
// away, is static (scenes/crowd.lua). Tolerances for single precision relative to the camera: 1e-5 of the depth; 1e-3
// px.
TEST_F(TrailTest, HitsAreTheSurfacesAlongTheRay) {
  Shot shot = oracle::with(oracle::shotOf("crowd", 64, 40), "none");
  std::vector<TrailHit> hits = follow(bench(), shot, 20, 13).trail.hits;
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_EQ(hits[0].instance, "high");
  EXPECT_NEAR(hits[0].depth, 16, 1.6e-4);
  EXPECT_NEAR(hits[0].velocity.x, 9.125, 1e-3);
  EXPECT_NEAR(hits[0].velocity.y, 3.25, 1e-3);
  EXPECT_NEAR(hits[0].normal.z, 1, 1e-6);
  EXPECT_TRUE(hits[0].front);
  EXPECT_EQ(hits[1].instance, "wall");
  EXPECT_EQ(hits[1].layer, 1);
  EXPECT_NEAR(hits[1].depth, 32, 3.2e-4);
  EXPECT_NEAR(hits[1].velocity.x, 0, 1e-3);
}

TEST_F(TrailTest, PixelsOutsideAreRefused) {
  Shot shot = oracle::with(oracle::shotOf("crowd", 64, 40), "none");
  for (auto [x, y] : {std::pair(64, 0), std::pair(0, 40), std::pair(-1, 0)}) {
    try {
      follow(bench(), shot, x, y);
      ADD_FAILURE() << x << "," << y;
    } catch (const Error& error) {
      EXPECT_EQ(error.exitCode(), 2);
      EXPECT_NE(std::string(error.what()).find("64x40"), std::string::npos) << error.what();
    }
  }
}

TEST(Trail, PixelsAreParsed) {
  EXPECT_EQ(parsePixel("12,7"), (std::array<int, 2>{12, 7}));
  for (const char* text : {"", "12", "12,", ",7", "12,7,3", "12.5,7", "a,b", "12, 7", "99999999999,1"})
    EXPECT_THROW(parsePixel(text), Error) << text;
}

TEST(Trail, NumbersRoundTripToTheSameFloat) {
  std::vector<double> values;
  for (float value : {0.1f, 1.0f / 3, 1e-38f, 3.4e38f, 1e-45f, 16777217.0f, -0.0f, 2.5f}) values.push_back(value);
  Trail trail = {"p", 0, 0, 64, 40, {rowOf("rgba32f", values)}, {}};
  Json read = Json::parse(toJson(trail).dump())["passes"][0]["values"];
  for (size_t i = 0; i < values.size(); ++i)
    EXPECT_TRUE(sameBits(read[i].get<double>(), float(values[i]))) << values[i];
  EXPECT_NE(tableOf(trail).find("0.1  0.33333334  1e-38"), std::string::npos) << tableOf(trail);
}

TEST(Trail, NonFiniteNumbersAreNamed) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Trail trail = {"p", 0, 0, 64, 40, {rowOf("rgba32f", {NAN, inf, -inf})}, {}};
  EXPECT_EQ(toJson(trail)["passes"][0]["values"], Json::parse(R"(["nan", "inf", "-inf"])"));
  EXPECT_NE(tableOf(trail).find("nan  inf  -inf"), std::string::npos);
  EXPECT_NE(tableOf(trail).find("no surface on the ray"), std::string::npos);
}

}  // namespace trail_test
