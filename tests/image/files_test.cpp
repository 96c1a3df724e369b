// SPDX-License-Identifier: MIT
// Image files round-trip, have reproducible bytes, and are refused by name if damaged.
#include "base/files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>

#include "base/error.h"
#include "base/process.h"
#include "common/temporary_folder.h"
#include "image/exr.h"
#include "image/metrics.h"
#include "image/png.h"
#include "image/tone.h"

using namespace strobe;
using namespace strobe::image;

namespace files_test {

class ImageFiles : public ::testing::Test {
 protected:
  Path path(const std::string& name) const { return folder_ / name; }

 private:
  const strobe::testing::TemporaryFolder folder_;
};

template <class Read>
std::string refusal(Read read) {
  try {
    read();
  } catch (const Error& error) {
    EXPECT_EQ(error.exitCode(), 1);
    return error.what();
  }
  return "nothing was refused";
}

void expectRefusal(const std::string& message, const std::string& file) {
  EXPECT_NE(message.find(file), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

Image ramp(int width, int height, int channels) {
  Image image(width, height, channels);
  for (size_t i = 0; i < image.values.size(); ++i) image.values[i] = float(i % 256) / 255;
  return image;
}

ExrFile sample() {
  ExrFile content;
  Image colour = ramp(37, 21, 4), velocity(37, 21, 2), depth(37, 21, 1, INFINITY);
  colour.at(2, 3, 1) = 1e30f;
  velocity.at(5, 6, 0) = -123.456f;
  content.add("", {"R", "G", "B", "A"}, colour);
  content.add("velocity", {"X", "Y"}, velocity);
  content.add("", {"Z"}, depth);
  content.add("soft", {"R", "G", "B"}, ramp(37, 21, 3), ExrKind::half);
  UintImage ids{37, 21, 1, std::vector<uint32_t>(37 * 21, 4000000007u)};
  content.add("", {"id"}, ids);
  content.texts["run"] = "{\"seed\":1}";
  content.frames_per_second = {24000, 1001};
  content.shutter_angle = 180.0f;
  content.exposure_s = 1 / 48.0f;
  content.camera_from_world = glm::translate(glm::mat4(1), glm::vec3(1, 2, 3));
  content.ndc_from_world = glm::perspective(1.0f, 1.5f, 0.1f, 100.0f);
  return content;
}

TEST_F(ImageFiles, ExrKeepsEverything) {
  ExrFile written = sample();
  writeExr(path("a.exr"), written);
  ExrFile read = readExr(path("a.exr"));
  ASSERT_EQ(read.channels.size(), written.channels.size());
  for (const ExrChannel& channel : written.channels) {
    const ExrChannel* back = read.find(channel.name);
    ASSERT_NE(back, nullptr) << channel.name;
    EXPECT_EQ(back->kind, channel.kind) << channel.name;
    EXPECT_EQ(back->ids, channel.ids) << channel.name;
    // Half floats have 11 significant bits: values in [0,1] are rounded by at most half a step, 2^-12.
    double tolerance = channel.kind == ExrKind::half ? std::exp2(-12) : 0;
    ASSERT_EQ(back->values.size(), channel.values.size());
    for (size_t i = 0; i < channel.values.size(); ++i)
      EXPECT_TRUE(back->values[i] == channel.values[i] || std::abs(back->values[i] - channel.values[i]) <= tolerance)
          << channel.name << " " << i;
  }
  EXPECT_EQ(read.texts, written.texts);
  EXPECT_EQ(read.frames_per_second, written.frames_per_second);
  EXPECT_EQ(read.shutter_angle, written.shutter_angle);
  EXPECT_EQ(read.exposure_s, written.exposure_s);
  EXPECT_EQ(read.camera_from_world, written.camera_from_world);
  EXPECT_EQ(read.ndc_from_world, written.ndc_from_world);
}

TEST_F(ImageFiles, ExrLayersBecomeImages) {
  writeExr(path("a.exr"), sample());
  ExrFile content = readExr(path("a.exr"));
  Image colour = ramp(37, 21, 4);
  colour.at(2, 3, 1) = 1e30f;
  EXPECT_EQ(channelsOf(content, {"R", "G", "B", "A"}, "a.exr").values, colour.values);
  EXPECT_EQ(colourOf(content, "", "a.exr").values, threeChannels(colour).values);
  EXPECT_EQ(colourOf(content, "Z", "a.exr").channels, 3);
  EXPECT_EQ(channelsOf(content, {"velocity.X", "velocity.Y"}, "a.exr").at(5, 6, 0), -123.456f);
  EXPECT_EQ(idsOf(content, {"id"}, "a.exr").at(0, 0, 0), 4000000007u);
  expectRefusal(refusal([&] { colourOf(content, "velocity", "a.exr"); }), "a.exr");
  std::string message = refusal([&] { channelsOf(content, {"velocity.x"}, "a.exr"); });
  EXPECT_NE(message.find("velocity.X"), std::string::npos) << message;
  expectRefusal(refusal([&] { idsOf(content, {"Z"}, "a.exr"); }), "a.exr");
}

TEST_F(ImageFiles, DamagedExrIsRefused) {
  std::string bytes = encodeExr(sample());
  size_t whole = bytes.size();
  for (size_t length : {size_t(0), size_t(3), size_t(4), size_t(100), size_t(400), whole / 2, whole - 1}) {
    writeFileAtomically(path("cut.exr"), std::string_view(bytes).substr(0, length));
    expectRefusal(refusal([&] { readExr(path("cut.exr")); }), "cut.exr");
  }
  writeFileAtomically(path("text.exr"), std::string_view("no picture at all"));
  expectRefusal(refusal([&] { readExr(path("text.exr")); }), "text.exr");
  std::string missing = refusal([&] { readExr(path("missing.exr")); });
  expectRefusal(missing, "missing.exr");
  EXPECT_NE(missing.find("No such file"), std::string::npos) << missing;
}

// A file with one damaged byte is refused or gives an image of sane size; it never crashes.
TEST_F(ImageFiles, FlippedBytesNeverCrash) {
  std::string bytes = encodeExr(sample());
  int refused = 0, tried = 0;
  for (size_t i = 4; i < bytes.size(); i += 7) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 0xa5);
    writeFileAtomically(path("bad.exr"), damaged);
    ++tried;
    try {
      EXPECT_LE(readExr(path("bad.exr")).width, 65536);
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_GT(tried, 100);
  EXPECT_GT(refused, 0);
}

TEST_F(ImageFiles, PngRoundTripIsExact) {
  for (int channels : {1, 3, 4}) {
    Image display = ramp(33, 17, channels);
    writePng(path("a.png"), display);
    Image read = readPng(path("a.png"));
    ASSERT_EQ(read.channels, channels == 1 ? 3 : channels);
    for (int c = 0; c < channels; ++c)
      for (int y = 0; y < 17; ++y)
        for (int x = 0; x < 33; ++x) EXPECT_EQ(read.at(x, y, c), display.at(x, y, c));
    EXPECT_EQ(encodePng(display), encodePng(display));
  }
}

TEST_F(ImageFiles, PngClampsAndRounds) {
  Image display(4, 1, 1);
  display.values = {-1, 2, NAN, 0.5f};
  writePng(path("a.png"), display);
  Image read = readPng(path("a.png"));
  EXPECT_EQ(read.at(0, 0, 0), 0);
  EXPECT_EQ(read.at(1, 0, 0), 1);
  EXPECT_EQ(read.at(2, 0, 0), 0);
  EXPECT_EQ(read.at(3, 0, 0), 128 / 255.0f);
}

TEST_F(ImageFiles, DamagedPngIsRefused) {
  std::string bytes = encodePng(ramp(64, 64, 3));
  for (size_t length : {size_t(0), size_t(8), size_t(20), bytes.size() / 2}) {
    writeFileAtomically(path("cut.png"), std::string_view(bytes).substr(0, length));
    expectRefusal(refusal([&] { readPng(path("cut.png")); }), "cut.png");
  }
  expectRefusal(refusal([&] { readPng(path("missing.png")); }), "missing.png");
}

// JPEG files decoded by ImageMagick: error decreases and size increases with quality.
TEST_F(ImageFiles, JpegIsDecodedByAnotherProgram) {
  for (int channels : {1, 3}) {
    Image display = ramp(64, 48, channels);
    double last = 1;
    size_t size = 0;
    for (int quality : {20, 60, 95}) {
      std::string bytes = encodeJpeg(display, quality);
      EXPECT_EQ(bytes, encodeJpeg(display, quality));
      EXPECT_GT(bytes.size(), size);
      size = bytes.size();
      writeFileAtomically(path("a.jpg"), bytes);
      ProgramEnd end = run({.arguments = {"convert", path("a.jpg").string(), path("b.png").string()}});
      if (!end.succeeded()) GTEST_SKIP() << "no ImageMagick to read it";
      Image read = readPng(path("b.png"));
      double error = rootMeanSquaredError(read, threeChannels(display));
      EXPECT_LT(error, last) << quality;
      last = error;
    }
    EXPECT_LT(last, 0.02) << channels;
  }
}

TEST(Srgb, HasKnownValuesAndAnInverse) {
  // IEC 61966-2-1: the linear segment ends at 0.0031308; 0.5 encodes to 1.055 * 0.5^(1/2.4) - 0.055.
  EXPECT_FLOAT_EQ(encodeSrgb(0.002f), 0.02584f);
  EXPECT_NEAR(encodeSrgb(0.5f), 1.055 * std::pow(0.5, 1 / 2.4) - 0.055, 1e-6);
  EXPECT_EQ(encodeSrgb(-3.0f), 0);
  EXPECT_NEAR(encodeSrgb(9.0f), 1, 1e-6);
  EXPECT_EQ(encodeSrgb(NAN), 0);
  // Eight-bit values are unchanged by decoding and encoding.
  for (int i = 0; i < 256; ++i) EXPECT_EQ(std::lround(encodeSrgb(decodeSrgb(i / 255.0f)) * 255), i);
}

TEST(ToneMapping, ExposesThenClamps) {
  Image image(2, 1, 3, 0.25f);
  image.at(1, 0, 0) = 4;
  Image shown = toneMap(image, {1, ToneMap::Curve::clamp});
  EXPECT_FLOAT_EQ(shown.at(0, 0, 0), encodeSrgb(0.5f));
  EXPECT_NEAR(shown.at(1, 0, 0), 1, 1e-6);
  Image filmic = toneMap(image, {0, ToneMap::Curve::filmic});
  EXPECT_LT(filmic.at(1, 0, 0), 1);
  EXPECT_GT(filmic.at(1, 0, 0), filmic.at(0, 0, 0));
}

}  // namespace files_test
