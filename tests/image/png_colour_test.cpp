// SPDX-License-Identifier: MIT
// Colour of PNG files: bit depth, gamma, primaries and profiles, with files written byte by byte.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "base/files.h"
#include "common/temporary_folder.h"
#include "image/comparison.h"
#include "image/primaries.h"
#include "image/tone.h"

namespace strobe::image {
namespace png_colour_test {

std::string bigEndian(uint32_t value) {
  return {char(value >> 24), char(value >> 16 & 255), char(value >> 8 & 255), char(value & 255)};
}

uint32_t crcOf(const std::string& bytes) {
  uint32_t crc = ~0u;
  for (unsigned char byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? crc >> 1 ^ 0xedb88320u : crc >> 1;
  }
  return ~crc;
}

std::string chunk(const std::string& type, const std::string& data) {
  return bigEndian(uint32_t(data.size())) + type + data + bigEndian(crcOf(type + data));
}

// One stored deflate block in a zlib container.
std::string zlib(const std::string& bytes) {
  uint32_t a = 1, b = 0;
  for (unsigned char byte : bytes) a = (a + byte) % 65521, b = (b + a) % 65521;
  auto size = uint16_t(bytes.size());
  std::string head = {
      '\x78', '\x01', '\x01', char(size & 255), char(size >> 8), char(~size & 255), char(~size >> 8 & 255)};
  return head + bytes + bigEndian(b << 16 | a);
}

using Levels = std::vector<std::array<int, 3>>;

// PNG file with one row of RGB pixels, 8 or 16 bits, preceded by `chunks`.
std::string png(int bits, const Levels& levels, const std::string& chunks = "") {
  std::string row(1, '\0');
  for (const auto& pixel : levels)
    for (int level : pixel) {
      if (bits == 16) row += char(level >> 8);
      row += char(level & 255);
    }
  std::string head = bigEndian(uint32_t(levels.size())) + bigEndian(1) + std::string{char(bits), 2, 0, 0, 0};
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", head) + chunks + chunk("IDAT", zlib(row)) + chunk("IEND", "");
}

Levels grey(const std::vector<int>& levels) {
  Levels pixels;
  for (int level : levels) pixels.push_back({level, level, level});
  return pixels;
}

std::string gamma(uint32_t times_100000) { return chunk("gAMA", bigEndian(times_100000)); }

std::string chromaticities(const std::array<uint32_t, 8>& times_100000) {
  std::string data;
  for (uint32_t value : times_100000) data += bigEndian(value);
  return chunk("cHRM", data);
}

const std::array<uint32_t, 8> kSrgb = {31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000};
const std::array<uint32_t, 8> kDisplayP3 = {31270, 32900, 68000, 32000, 26500, 69000, 15000, 6000};

ComparedPicture read(const std::string& bytes) {
  testing::TemporaryFolder folder;
  writeFileAtomically(folder.path() / "a.png", bytes);
  return readPicture(folder.path() / "a.png");
}

std::string notesOf(const ComparedPicture& picture) { return fmt::format("{}", fmt::join(picture.notes, "; ")); }

TEST(PngColour, DoesNotDependOnBitDepth) {
  Levels eight, sixteen;
  for (int level = 0; level < 256; ++level) {
    eight.push_back({level, 255 - level, 7});
    sixteen.push_back({257 * level, 257 * (255 - level), 257 * 7});
  }
  ComparedPicture coarse = read(png(8, eight)), fine = read(png(16, sixteen));
  for (size_t i = 0; i < coarse.linear.values.size(); ++i)
    EXPECT_NEAR(fine.linear.values[i], coarse.linear.values[i], 1e-7) << i;
  EXPECT_FLOAT_EQ(fine.linear.at(128, 0, 0), decodeSrgb(128 / 255.0f));
  EXPECT_EQ(notesOf(coarse) + notesOf(fine), "");
}

TEST(PngColour, SixteenBitsAreNotRoundedToEight) {
  ComparedPicture picture = read(png(16, grey({30000, 30001})));
  EXPECT_NE(picture.linear.at(0, 0, 0), picture.linear.at(1, 0, 0));
}

// sRGB files carry gAMA of 1/2.2 and cHRM of Rec. 709 for old programs.
TEST(PngColour, StatedSrgbNeedsNoNote) {
  std::string srgb = chunk("sRGB", std::string(1, '\0'));
  for (const std::string& chunks : {srgb, gamma(45455), gamma(45455) + chromaticities(kSrgb) + srgb,
                                    chunk("cICP", {1, 13, 0, 1}), chromaticities(kSrgb)}) {
    ComparedPicture picture = read(png(8, grey({128}), chunks));
    EXPECT_FLOAT_EQ(picture.linear.at(0, 0, 0), decodeSrgb(128 / 255.0f));
    EXPECT_EQ(notesOf(picture), "");
  }
}

TEST(PngColour, AppliesTheGamma) {
  for (int bits : {8, 16}) {
    int half = bits == 8 ? 128 : 128 * 257;
    ComparedPicture linear = read(png(bits, grey({half}), gamma(100000)));
    EXPECT_NEAR(linear.linear.at(0, 0, 0), 128 / 255.0, 1e-6);
    EXPECT_EQ(notesOf(linear), "its values are decoded with its gamma of 1, not as sRGB");
    EXPECT_NEAR(read(png(bits, grey({half}), gamma(55556))).linear.at(0, 0, 0), std::pow(128 / 255.0, 1.8), 1e-5);
  }
}

// Columns of CSS Color 4's matrix from linear Display P3 to linear sRGB.
TEST(PngColour, ConvertsPrimaries) {
  ComparedPicture picture = read(png(8, {{255, 0, 0}, {0, 255, 0}, {255, 255, 255}}, chromaticities(kDisplayP3)));
  const float kRed[] = {1.2249402f, -0.0420570f, -0.0196376f}, kGreen[] = {-0.2249402f, 1.0420570f, -0.0786360f};
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(picture.linear.at(0, 0, c), kRed[c], 1e-5) << c;
    EXPECT_NEAR(picture.linear.at(1, 0, c), kGreen[c], 1e-5) << c;
    EXPECT_NEAR(picture.linear.at(2, 0, c), 1, 1e-5) << c;
  }
  EXPECT_NE(notesOf(picture).find("converted to Rec. 709 from its primaries: red 0.68 0.32"), std::string::npos)
      << notesOf(picture);
}

TEST(PngColour, UnusedProfilesAreNamed) {
  std::string profile = chunk("iCCP", std::string("Wide\0\0", 6) + zlib(std::string(128, '\0')));
  EXPECT_NE(notesOf(read(png(8, grey({9}), profile))), "");
  std::string pq = notesOf(read(png(16, grey({9}), chunk("cICP", {9, 16, 0, 1}))));
  EXPECT_EQ(pq, "its cICP chunk (9 16 0 1) is not used: only sRGB (1 13 0 1) is supported");
}

// The size in a header is not allocated without data.
TEST(PngColour, RefusesASizeBeyondItsBytes) {
  std::string head = bigEndian(60000) + bigEndian(60000) + std::string{16, 6, 0, 0, 0};
  std::string bytes = "\x89PNG\r\n\x1a\n" + chunk("IHDR", head) + chunk("IDAT", zlib("x")) + chunk("IEND", "");
  EXPECT_THROW(read(bytes), Error);
}

// ACEScg to Rec. 709 with Bradford adaptation, from the ACES documents.
TEST(Primaries, OfAcescgAreConvertedToRec709) {
  const Primaries acescg{{0.713, 0.293}, {0.165, 0.83}, {0.128, 0.044}, {0.32168, 0.33767}};
  const double kWanted[3][3] = {
      {1.70505, -0.62179, -0.08326}, {-0.13026, 1.14080, -0.01055}, {-0.02400, -0.12897, 1.15297}};
  glm::dmat3 found = rec709From(acescg);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      EXPECT_NEAR(found[column][row], kWanted[row][column], 2e-4) << row << column;
}

TEST(Primaries, OnALineAreNotUsed) {
  Primaries line{{0.2, 0.2}, {0.3, 0.3}, {0.4, 0.4}, {0.3127, 0.329}};
  Image colour(1, 1, 3, 0.5f);
  EXPECT_NE(convertStated(colour, line).find("are not used"), std::string::npos);
  EXPECT_EQ(colour.at(0, 0, 0), 0.5f);
}

}  // namespace png_colour_test
}  // namespace strobe::image
