// SPDX-License-Identifier: MIT
// Images that are small in the file and large in memory.
#include "image/image.h"
#include "image/png.h"
#include "scene/gltf_asset.h"

namespace strobe::scene {
namespace gltf_images_test {

std::string uriOf(const std::string& bytes) {
  return "data:application/octet-stream;base64," + base64({bytes.begin(), bytes.end()});
}

// A triangle whose material has the images of `uris` as base colours, and the first as roughness too.
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

// A header alone: 16384 x 16384 texels of RGBA.
std::string hugeHeader() {
  return std::string("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\x40\0\0\0\x40\0\x08\x06\0\0\0\0\0\0\0", 33);
}

class GltfImages : public Gltf {};

// Texels of 4 bytes, once decoded and once with all levels (4/3) for each texture, and 5/4 of the largest as floats.
TEST_F(GltfImages, AreSummedBeforeAnyIsDecoded) {
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

// Each takes 1 GiB as it is decoded, so that any machine has too little for all.
TEST_F(GltfImages, OfKilobytesThatDecodeToGibibytesAreRefused) {
  std::vector<std::string> uris(64, uriOf(hugeHeader()));
  uris[3] = uriOf(image::encodePng(image::Image(8, 8, 3)));
  const std::string refusal = failure(textured(uris), {.most_bytes = uint64_t{64} << 30});
  EXPECT_NE(refusal.find("its decoded images need 153.3 GiB of memory, but only "), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("the largest is images[0] of 16384x16384 texels"), std::string::npos) << refusal;
}

}  // namespace gltf_images_test
}  // namespace strobe::scene
