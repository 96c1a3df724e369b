// SPDX-License-Identifier: MIT
// Images with a small file and a large decoded size.
#include "image/image.h"
#include "image/png.h"
#include "scene/gltf_asset.h"

namespace strobe::scene {
namespace gltf_images_test {

std::string uriOf(const std::string& bytes) {
  return "data:application/octet-stream;base64," + base64({bytes.begin(), bytes.end()});
}

// A triangle with the images of `uris` as base colours, and the first image also as roughness.
Json textured(const std::vector<std::string>& uris) {
  Json json = triangle().whole();
  for (const std::string& uri : uris) {
    const int i = int(json["images"].size());
    json["images"].push_back({{"uri", uri}});
    json["textures"].push_back({{"source", i}});
    json["materials"].push_back({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", i}}}}}});
  }
  json["materials"][0]["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {{"index", 0}};
  return json;
}

// Header of a PNG file without pixels: 16384 x 16384 texels of RGBA.
std::string hugeHeader() {
  return std::string("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\x40\0\0\0\x40\0\x08\x06\0\0\0\0\0\0\0", 33);
}

class GltfImages : public Gltf {};

// Sum of 4 bytes per texel: once decoded, once with all levels (4/3) per texture, and 5/4 of the largest image as
// floats.
TEST_F(GltfImages, AreSummedBeforeDecoding) {
  const Json json = textured(
      {uriOf(image::encodePng(image::Image(96, 48, 3))), uriOf(image::encodeJpeg(image::Image(32, 16, 3), 90))});
  const uint64_t png = 96 * 48, jpeg = 32 * 16;
  const uint64_t needed = 4 * (png + jpeg) + png * 16 / 3 + jpeg * 16 / 3 + png * 16 / 3 + png * 5 / 4 * 16;
  EXPECT_EQ(load(json, {.most_bytes = needed}).textures.size(), 3u);
  EXPECT_TRUE(failure(json, {.most_bytes = needed - 1})
                  .ends_with("a.gltf: its decoded images need 160 KiB of memory, but only 160 KiB are available; the "
                             "largest is images[0] of 96x48 texels"))
      << failure(json, {.most_bytes = needed - 1});
}

// Each image takes 1 GiB when decoded, so that no machine has memory for all.
TEST_F(GltfImages, OfKilobytesThatDecodeToGibibytesAreRefused) {
  std::vector<std::string> uris(64, uriOf(hugeHeader()));
  uris[3] = uriOf(image::encodePng(image::Image(8, 8, 3)));
  const std::string refusal = failure(textured(uris), {.most_bytes = uint64_t{64} << 30});
  EXPECT_NE(refusal.find("its decoded images need 153.3 GiB of memory, but only "), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("the largest is images[0] of 16384x16384 texels"), std::string::npos) << refusal;
}

}  // namespace gltf_images_test
}  // namespace strobe::scene
