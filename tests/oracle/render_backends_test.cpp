// SPDX-License-Identifier: MIT
// A picture is a function of its description. It does not depend on the ray tracing backend, the run or the taps.
#include <fmt/format.h>

#include "oracle/render.h"

namespace strobe::oracle {
namespace render_backends_test {

class RenderBackends : public RenderTest {
 protected:
  static lab::Shot crowd(const std::string& pipeline, const std::vector<std::string>& settings = {}) {
    return with(shotOf("crowd", 64, 40), pipeline, settings);
  }
  static Json outputs(const lab::Picture& picture) { return picture.record["outputs"]; }
  static uint64_t raysOf(const lab::Picture& picture, const std::string& node, const std::string& backend) {
    std::string name = fmt::format("{}.rays_{}", node, backend);
    for (const auto& [counter, count] : picture.frame.counters)
      if (counter == name) return count;
    return 0;
  }
};

TEST_F(RenderBackends, AllGiveTheSamePictures) {
  const std::vector<std::string> names = backends();
  if (names.size() < 3)
    GTEST_SKIP() << bench().device().info().name << " has " << fmt::format("{}", fmt::join(names, ", ")) << " alone";
  struct Traced {
    std::string node;
    lab::Shot shot;
    bool asks_alike = true;  // false: the own tree traces some rays against a single instance, other backends do not
  };
  const Traced cases[] = {
      {"shade", crowd("none", {"tile_light_visibility.per_tile=false"})},
      {"ray_reveal", crowd("hybrid_layered", {"tile=8", "limit=0.25"})},
      {"ray_reveal", crowd("hybrid", {"preset=text", "tile=8", "limit=0.25"})},
      {"ray_reveal", crowd(hybridSteps(), {"mask=all", "advance=restart", "tile=8", "limit=0.25"})},
      // Many static instances; the runtime's own tree over them is built once.
      {"ray_reveal", with(shotOf("crowd", 64, 40, {{"crumbs", 300}}), "hybrid_layered", {"tile=8", "limit=0.25"})},
      // Rays that skip the box pass over its back at once.
      {"ray_reveal", with(shotOf("turning_box", 64, 36, {}), hybridSteps(), {"mask=all"})},
      {"sample", crowd("ground_truth", {"samples=12", "pixel=box", "times=stratified", "slices=4"}), false},
  };
  for (Traced traced : cases) {
    std::map<std::string, lab::Picture> pictures;
    for (const std::string& name : names) {
      traced.shot.backend = name;
      pictures[name] = render(traced.shot);
    }
    const lab::Picture& first = pictures.at(names.front());
    EXPECT_GT(raysOf(first, traced.node, names.front()), 0u) << traced.node;
    for (const std::string& name : names) {
      EXPECT_EQ(outputs(first), outputs(pictures.at(name))) << traced.node << ", " << name;
      // Each picture used its own backend only, with equal numbers of rays.
      for (const std::string& other : names) {
        const uint64_t rays = raysOf(pictures.at(name), traced.node, other);
        if (name != other) EXPECT_EQ(rays, 0u) << traced.node << ", " << name;
        else if (!traced.asks_alike) EXPECT_GT(rays, 0u) << traced.node << ", " << name;
        else EXPECT_EQ(rays, raysOf(first, traced.node, names.front())) << traced.node << ", " << name;
      }
    }
  }
}

TEST_F(RenderBackends, TenRunsGiveOneHash) {
  for (const lab::Shot& shot : {crowd("hybrid_layered", {"jitter=hash"}), crowd("hybrid", {"preset=text"}),
                                crowd("ground_truth", {"samples=4", "times=stratified"})}) {
    Json first = outputs(render(shot));
    for (int run = 1; run < 10; ++run) EXPECT_EQ(outputs(render(shot)), first) << shot.pipeline << " run " << run;
  }
}

TEST_F(RenderBackends, SeedsChangeOnlyPicturesThatUseThem) {
  lab::Shot shot = crowd("hybrid_layered", {"jitter=hash"});
  Json first = outputs(render(shot));
  shot.seed = 1;
  EXPECT_NE(outputs(render(shot))["color"], first["color"]);
  lab::Shot plain = crowd("hybrid");
  first = outputs(render(plain));
  plain.seed = 1;
  EXPECT_EQ(outputs(render(plain)), first);
}

// Taps have their own memory. A picture that changes with a tap has read memory of another image.
TEST_F(RenderBackends, TapsChangeNoPicture) {
  for (lab::Shot shot : {crowd("hybrid_layered"), crowd("hybrid", {"preset=text"})}) {
    Json without = outputs(render(shot));
    for (const std::vector<std::string>& taps :
         {std::vector<std::string>{"mask.mask"},
          {"visibility.hit", "ray_reveal.depth"},
          {"gbuffer.velocity", "ray_reveal.velocity", "ray_reveal.valid", "shade.color"}}) {
      shot.taps = taps;
      lab::Picture picture = render(shot);
      EXPECT_EQ(outputs(picture), without) << fmt::format("{}", fmt::join(taps, " "));
      for (const std::string& tap : taps) EXPECT_EQ(picture.frame.taps.count(tap), 1u) << tap;
    }
  }
}

}  // namespace render_backends_test
}  // namespace strobe::oracle
