// SPDX-License-Identifier: MIT
// Files with several parts: each keeps its name, size and channels, and is found by its name or by the name of a layer.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "base/error.h"
#include "common/refusal.h"
#include "common/temporary_folder.h"
#include "image/comparison.h"
#include "image/exr.h"

using namespace strobe;
using namespace strobe::image;

namespace exr_parts_test {

class ExrParts : public ::testing::Test {
 protected:
  std::string refusalOf(const std::string& layer) const {
    return strobe::testing::refusalOf([&] { colourOf(readExrLayer(file_, layer), layer, file_); });
  }

  const strobe::testing::TemporaryFolder folder_;
  const Path file_ = folder_.path() / "parts.exr";
};

Image filled(int width, int height, int channels, float from) {
  Image image(width, height, channels);
  for (size_t i = 0; i < image.values.size(); ++i) image.values[i] = from + float(i) / 8;
  return image;
}

// A 20 x 12 picture, one of half the size, a larger tile image, and ids.
ExrFile sample() {
  ExrFile content;
  content.name = "color";
  content.add("", {"R", "G", "B", "A"}, filled(20, 12, 4, 0));
  content.texts["strobe"] = "{}";
  content.shutter_angle = 90.0f;
  ExrPart& reveal = content.further.emplace_back();
  reveal.name = "ray_reveal.color";
  reveal.add("ray_reveal.color", {"R", "G", "B", "A"}, filled(10, 6, 4, 1e-3f), ExrKind::half);
  ExrPart& depth = content.further.emplace_back();
  depth.name = "depth";
  depth.add("", {"Z"}, filled(33, 1, 1, INFINITY));
  ExrPart& ids = content.further.emplace_back();
  ids.name = "id";
  ids.add("", {"id", "geometry"}, UintImage{2, 2, 2, {0, 1, 4294967295u, 3, 4, 5, 6, 7}});
  ids.texts["strobe"] = "of this part alone";
  return content;
}

TEST_F(ExrParts, KeepTheirNamesSizesAndValues) {
  ExrFile written = sample();
  writeExr(file_, written);
  ExrFile read = readExr(file_);
  ASSERT_EQ(read.parts().size(), written.parts().size());
  for (size_t i = 0; i < written.parts().size(); ++i) {
    const ExrPart &before = *written.parts()[i], &after = *read.parts()[i];
    EXPECT_EQ(after.name, before.name);
    EXPECT_EQ(after.texts, before.texts) << before.name;
    EXPECT_EQ(after.width, before.width) << before.name;
    EXPECT_EQ(after.height, before.height) << before.name;
    ASSERT_EQ(after.channels.size(), before.channels.size()) << before.name;
    for (const ExrChannel& channel : before.channels) {
      const ExrChannel* back = after.find(channel.name);
      ASSERT_NE(back, nullptr) << channel.name;
      EXPECT_EQ(back->kind, channel.kind) << channel.name;
      EXPECT_EQ(back->ids, channel.ids) << channel.name;
      if (channel.kind == ExrKind::real) EXPECT_EQ(back->values, channel.values) << channel.name;
    }
  }
  EXPECT_EQ(read.shutter_angle, 90.0f);
  EXPECT_EQ(read.part("depth"), &read.further[1]);
  EXPECT_EQ(read.part("normal"), nullptr);
}

TEST_F(ExrParts, BytesDependOnlyOnContent) {
  EXPECT_EQ(encodeExr(sample()), encodeExr(sample()));
  EXPECT_EQ(encodeExr(sample()).find("capDate"), std::string::npos);
}

// Found by the part's name and by a layer's name; a single channel is grey.
TEST_F(ExrParts, AreFoundByName) {
  ExrFile written = sample();
  written.further[1].channels[0].values.assign(33, 2.5f);
  writeExr(file_, written);
  for (const char* whole : {"", "color"}) {
    EXPECT_EQ(readExrLayer(file_, whole).name, "color");
    EXPECT_EQ(readPicture(file_, whole).linear.values, threeChannels(filled(20, 12, 4, 0)).values) << whole;
  }
  ExrFile half = readExrLayer(file_, "ray_reveal.color");
  EXPECT_EQ(half.width, 10);
  EXPECT_EQ(half.height, 6);
  EXPECT_TRUE(half.further.empty());
  EXPECT_EQ(readPicture(file_, "ray_reveal.color").linear.width, 10);
  for (const char* depth : {"depth", "Z"}) {
    EXPECT_EQ(readPicture(file_, depth).linear.values, std::vector<float>(99, 2.5f)) << depth;
    EXPECT_EQ(readExrLayer(file_, depth).name, "depth");
  }
  EXPECT_EQ(readPicture(file_, "id").linear.at(1, 1, 2), 6);  // a channel found by its name
  EXPECT_NE(refusalOf("velocity").find("layer 'velocity'; its channels are A, B, G, R"), std::string::npos)
      << refusalOf("velocity");
}

// A file with one damaged byte, or cut short, is refused or gives an image of sane size; it never crashes.
TEST_F(ExrParts, DamageNeverCrashes) {
  std::string bytes = encodeExr(sample());
  int refused = 0, tried = 0;
  for (size_t i = 4; i < bytes.size(); i += 5) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 0xa5);
    writeFileAtomically(file_, damaged);
    ++tried;
    try {
      const ExrFile read = readExr(file_);
      for (const ExrPart* part : read.parts()) EXPECT_LE(part->width, 65536);
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_GT(tried, 100);
  EXPECT_GT(refused, 0);
  for (size_t length = 4; length < bytes.size(); length += 97) {
    writeFileAtomically(file_, std::string_view(bytes).substr(0, length));
    EXPECT_THROW(readExr(file_), Error) << length;
  }
}

}  // namespace exr_parts_test
