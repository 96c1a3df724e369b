// SPDX-License-Identifier: MIT
// Ids beyond the integers of single precision: comparisons of ids give the same pictures as with small ids.

#include "common/temporary_folder.h"
#include "image/exr.h"
#include "lab/capture.h"
#include "oracle/render.h"
#include "session/home.h"

namespace strobe::stability {
namespace ids_test {

using oracle::with;

class Ids : public oracle::RenderTest {
 protected:
  static lab::Picture render(const lab::Shot& shot) { return bench().render(shot); }
  static lab::Picture render(const session::EditableHome& home, const lab::Shot& shot) {
    return lab::Workbench(home.home(), bench()).render(shot);
  }
};

// Adds `base` to the ids of raster and rays: neighbouring ids differ in the lowest bit.
void raiseIds(const session::EditableHome& home, const std::string& base) {
  home.edit("shaders/gbuffer/gbuffer.glsl", "id = uvec2(ids.x,", "id = uvec2(ids.x + " + base + ",");
  home.edit("shaders/hybrid/ray_reveal.glsl", "uvec2(hit.instance, hit.geometry) + 1u",
            "uvec2(hit.instance, hit.geometry) + uvec2(1u + " + base + ", 1u)");
}

// Passes that compare ids: edge detectors, masks, composites.
std::vector<lab::Shot> shotsThatCompareIds() {
  const lab::Shot crowd = oracle::shotOf("crowd", 48, 30);
  return {with(crowd, "hybrid", {"edge=id"}),
          with(crowd, "hybrid", {"edge=silhouette"}),
          with(crowd, "hybrid", {"edge=sobel"}),
          with(crowd, "hybrid", {"own_edge=true"}),
          with(crowd, "hybrid_layered"),
          with(crowd, oracle::hybridSteps(), {"composite=in_gather"}),
          with(crowd, oracle::hybridSteps(), {"mask=moving"})};
}

TEST_F(Ids, DifferInTheLowestBitBeyondSinglePrecision) {
  const std::vector<lab::Shot> shots = shotsThatCompareIds();
  std::vector<lab::Picture> small;
  for (const lab::Shot& shot : shots) small.push_back(render(shot));
  for (const char* base : {"0x1000000u", "0xfffffff8u"}) {  // from 2^24; up to 2^32 - 2 with six instances
    session::EditableHome home;
    raiseIds(home, base);
    for (size_t i = 0; i < small.size(); ++i) {
      lab::Picture large = render(home, shots[i]);
      EXPECT_NE(large.frame.outputs.at("id").uints.values, small[i].frame.outputs.at("id").uints.values);
      EXPECT_TRUE(oracle::identical(oracle::colorOf(large), oracle::colorOf(small[i]))) << base << " " << i;
      EXPECT_TRUE(oracle::identical(oracle::imageOf(large, "mask"), oracle::imageOf(small[i], "mask"))) << base;
    }
  }
}

TEST_F(Ids, AreWrittenUnchanged) {
  session::EditableHome home;
  raiseIds(home, "0xfffffff8u");
  lab::Picture picture = render(home, with(oracle::shotOf("crowd", 48, 30), "none"));
  const Path file = testing::processFolder() / "ids.exr";
  lab::writePicture(picture, file, {.half = true});  // the option does not change integers
  image::ExrFile read = image::readExr(file);
  const image::UintImage& ids = picture.frame.outputs.at("id").uints;
  bool found = false;
  for (const auto& channel : read.channels) {
    if (channel.name != "id") continue;
    found = true;
    ASSERT_EQ(channel.ids.size() * 2, ids.values.size());
    for (size_t i = 0; i < channel.ids.size(); ++i) ASSERT_EQ(channel.ids[i], ids.values[2 * i]);
  }
  EXPECT_TRUE(found);
}

}  // namespace ids_test
}  // namespace strobe::stability
