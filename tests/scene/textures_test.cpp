// SPDX-License-Identifier: MIT
#include "scene/textures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "common/temporary_folder.h"
#include "scene/kept_textures.h"

namespace strobe::scene {
namespace textures_test {

Pattern patternOf(const std::string& type) {
  Pattern pattern;
  pattern.type = type;
  pattern.width = 48;
  pattern.height = 32;
  for (size_t i = 0; i < patternColors(type); ++i) pattern.colors.push_back(vec3(0.1f + 0.15f * i, 0.5f, 0.3f));
  return pattern;
}

TEST(Srgb, IsTheInverseOfTheEncoding) {
  for (int i = 11; i < 256; ++i)  // above the linear segment
    EXPECT_NEAR(1.055 * std::pow(linearFromSrgb(i / 255.0), 1 / 2.4) - 0.055, i / 255.0, 1e-7);
  EXPECT_NEAR(linearFromSrgb(0.5), 0.21404114, 1e-7);  // published value of the transfer curve
}

TEST(Levels, AreAveragedInLinearLight) {
  Texture texture;
  texture.width = 2;
  texture.height = 1;
  texture.levels = {{0, 0, 0, 255, 255, 255, 255, 255}};
  buildLevels(texture);
  ASSERT_EQ(texture.levels.size(), 2u);
  EXPECT_EQ(texture.levels[1], (std::vector<uint8_t>{188, 188, 188, 255}));  // half of the linear light, encoded
  texture.format = Texture::Format::Rgba8Unorm;
  buildLevels(texture);
  EXPECT_EQ(texture.levels[1][0], 128);
}

TEST(Levels, TransparentTexelsDoNotBleed) {
  Texture texture;
  texture.width = 2;
  texture.height = 1;
  texture.levels = {{200, 10, 10, 255, 0, 255, 0, 0}};
  buildLevels(texture);
  EXPECT_EQ(texture.levels[1], (std::vector<uint8_t>{200, 10, 10, 128}));
}

// For any size, the mean of a level equals the mean of the image: every texel has the same weight.
TEST(Levels, OddSizesKeepTheMean) {
  for (ivec2 size : {ivec2(5, 3), ivec2(7, 1), ivec2(1, 9), ivec2(13, 11)}) {
    std::vector<vec4> texels;
    for (int i = 0; i < size.x * size.y; ++i) texels.push_back(vec4(float(i * 7919 % 101), 0, 0, 1));
    double mean = 0;
    for (const vec4& t : texels) mean += t.x / texels.size();
    Texture texture = texelTexture(size.x, size.y, texels);
    buildLevels(texture);
    vec4 last;
    std::memcpy(&last, texture.levels.back().data(), 16);
    EXPECT_NEAR(last.x, mean, 1e-4 * mean) << size.x << "x" << size.y;
    for (size_t level = 0; level < texture.levels.size(); ++level) {
      size_t wanted = 16 * std::max(1, size.x >> level) * std::max(1, size.y >> level);
      EXPECT_EQ(texture.levels[level].size(), wanted);
    }
  }
}

TEST(Patterns, StripesHaveTheirShares) {
  Pattern pattern;
  pattern.type = "stripes";
  pattern.width = 64;
  pattern.height = 2;
  pattern.colors = {vec3(1), vec3(0)};
  pattern.widths = {3, 1};
  pattern.count = {4, 1};
  Texture texture = paintPattern(pattern);
  for (int x = 0; x < 64; ++x) EXPECT_EQ(texture.levels[0][4 * x], x % 16 < 12 ? 255 : 0) << x;
  EXPECT_NEAR(linearFromSrgb(texture.levels.back()[0] / 255.0), 0.75, 0.005);
}

TEST(KeptTextures, EqualThePaintedTextures) {
  namespace fs = std::filesystem;
  const testing::TemporaryFolder folder;
  auto kept = [&] { return std::distance(fs::directory_iterator(folder / "textures"), fs::directory_iterator()); };
  for (const std::string& type : patternNames()) {
    const Pattern pattern = patternOf(type);
    const Texture painted = paintPattern(pattern);
    for (const char* time : {"first", "second"}) {
      const Texture texture = keptPainter(folder.path())(pattern);
      EXPECT_EQ(texture.levels, painted.levels) << type << " " << time;
      EXPECT_EQ(texture.name, painted.name);
      EXPECT_EQ(ivec2(texture.width, texture.height), ivec2(painted.width, painted.height));
      EXPECT_EQ(texture.format, painted.format);
    }
  }
  EXPECT_EQ(size_t(kept()), patternNames().size());

  // Every number of a pattern changes the key.
  const Pattern stripes = patternOf("stripes");
  const auto before = kept();
  int count = 0;
  auto paintedAnew = [&](auto change) {
    Pattern other = stripes;
    change(other);
    EXPECT_EQ(keptPainter(folder.path())(other).levels, paintPattern(other).levels);
    EXPECT_EQ(kept(), before + ++count) << "change " << count;
  };
  paintedAnew([](Pattern& p) { p.width = 24; });
  paintedAnew([](Pattern& p) { p.height = 24; });
  paintedAnew([](Pattern& p) { p.colors[0].y = 0.25f; });
  paintedAnew([](Pattern& p) { p.colors.push_back(vec3(1)); });
  paintedAnew([](Pattern& p) { p.count.x = 3; });
  paintedAnew([](Pattern& p) { p.count.y = 3; });
  paintedAnew([](Pattern& p) { p.widths = {0.25}; });
  paintedAnew([](Pattern& p) { p.amount = 0.25; });
  paintedAnew([](Pattern& p) { p.line = 0.25; });
  paintedAnew([](Pattern& p) { p.seed = 2; });
}

}  // namespace textures_test
}  // namespace strobe::scene
