// SPDX-License-Identifier: MIT
// Light visibility of whole tiles equals the result of each of their shadow rays.
#include <fmt/format.h>

#include "oracle/render.h"
#include "shader/backends.h"

namespace strobe::oracle {
namespace render_shadows_test {

class RenderShadows : public RenderTest {
 protected:
  static lab::Shot occluders(int seed, Numbers numbers = {}) {
    numbers.emplace_back("seed", seed);
    return with(shotOf("occluders", 160, 90, numbers), "none");
  }

  // Draws the shot with and without visibility per tile, and expects one picture.
  static lab::Picture expectSame(const lab::Shot& shot, const std::string& what) {
    lab::Picture by_tiles = render(shot);
    lab::Picture by_rays = render(with(shot, shot.pipeline, {"tile_light_visibility.per_tile=false"}));
    EXPECT_TRUE(identical(colorOf(by_tiles), colorOf(by_rays))) << what;
    EXPECT_EQ(counterOf(by_rays, "tile_light_visibility.visible_lights") +
                  counterOf(by_rays, "tile_light_visibility.blocked_lights"),
              0u)
        << what;
    EXPECT_LE(raysOf(by_tiles), raysOf(by_rays)) << what;
    return by_tiles;
  }

  static uint64_t raysOf(const lab::Picture& picture) { return counterOf(picture, "shade.rays_bvh"); }
};

TEST_F(RenderShadows, TileVisibilityMatchesShadowRays) {
  uint64_t free = 0, stopped = 0;
  for (int seed = 1; seed <= 24; ++seed) {
    lab::Picture picture = expectSame(occluders(seed), fmt::format("seed {}", seed));
    free += counterOf(picture, "tile_light_visibility.visible_lights");
    stopped += counterOf(picture, "tile_light_visibility.blocked_lights");
  }
  EXPECT_GT(free, 500u);
  EXPECT_GT(stopped, 1000u);
}

TEST_F(RenderShadows, TileVisibilityMatchesAtAnyScale) {
  for (double scale : {1e-6, 1e-3, 1e3, 1e6})
    for (int seed : {3, 6, 7, 9})
      expectSame(occluders(seed, {{"scale", scale}}), fmt::format("scale {}, seed {}", scale, seed));
}

TEST_F(RenderShadows, TileVisibilityMatchesForAnyCameraAndSample) {
  for (int seed : {2, 5}) {
    expectSame(occluders(seed, {{"orthographic", 1}}), fmt::format("orthographic, seed {}", seed));
    lab::Shot shot = occluders(seed);
    shot.aa = 3;
    expectSame(shot, fmt::format("three samples a pixel, seed {}", seed));
  }
}

// The last tiles may be partial.
TEST_F(RenderShadows, TileVisibilityMatchesAtAnyPictureSize) {
  for (int width : {1, 7, 9, 63})
    expectSame(with(shotOf("occluders", width, width / 2 + 1, {{"seed", 4}}), "none"),
               fmt::format("{} px wide", width));
}

TEST_F(RenderShadows, TileVisibilitySavesRaysInARoom) {
  lab::Shot shot = with(lab::Shot{}, "none");
  shot.scene = "living_room";
  shot.width = 320;
  shot.height = 180;
  lab::Picture by_tiles = expectSame(shot, "living room");
  EXPECT_LT(raysOf(by_tiles), 3 * raysOf(render(with(shot, "none", {"tile_light_visibility.per_tile=false"}))) / 5);
}

// Acceleration structures of drivers cannot be traversed by a shader, so each ray is traced there.
TEST_F(RenderShadows, OtherBackendsTraceEachRay) {
  const shader::BackendRow& query_row = shader::rowOf(shader::Backend::Query);
  if (!shader::isPresent(query_row, bench().device().info())) GTEST_SKIP() << "no ray queries";
  lab::Shot shot = occluders(1);
  lab::Picture own = render(shot);
  shot.backend = "query";
  lab::Picture query = render(shot);
  EXPECT_EQ(counterOf(query, "tile_light_visibility.visible_lights") +
                counterOf(query, "tile_light_visibility.blocked_lights"),
            0u);
  EXPECT_GT(counterOf(query, "shade.rays_query"), raysOf(own));
}

}  // namespace render_shadows_test
}  // namespace strobe::oracle
