-- SPDX-License-Identifier: MIT
-- Guertin, McGuire and Nowrouzezahrai 2014, "A Fast and Stable Feature-Aware Motion Blur Filter". The exposure may have any
-- position relative to the raster time (anchor).
local pass      = require "strobe.pass"
local blur      = require "passes.lib.blur"
local ports     = require "passes.lib.blur_ports"
local jitter    = require "passes.lib.jitter"
local quantised = require "passes.lib.quantised"

local every_other = "with an even number of samples, as published, samples alternate between two directions from shutter " ..
  "open to shutter close; if time is reversed, each sample has the other direction"
local stands = "the random choice of a pixel's tile depends on the position on the screen, so it does not move with the scene"

return pass.compute {
  doc    = "Blur along the dominant displacement of the tile and along a second direction; taps have larger weights if " ..
           "their surfaces move along the sampled direction",
  fails  = "Inside silhouettes the blur is too opaque, as with `mcguire2012`, and the background is copied from outside. " ..
           "Coverage does not change linearly across an edge. Surfaces that move along neither direction stay sharp or " ..
           "leave noise. Each direction gets half of the samples.",
  size   = { of = "color" },
  reads  = ports.of_layer({ "second", "slowest" }, {
    variance = { optional = true,
      doc = "variance of motion directions per tile, 0 (parallel) to 1; absent: half of the samples take the second " ..
            "direction" },
  }),
  writes = ports.layer,
  if_no = ports.no_motion,
  params = {
    samples      = blur.samples { doc = "number of taps, both directions together" },
    directions   = blur.directions { default = "two",
      values = {
        one = "All taps along the dominant displacement, the longest one near the pixel. Fails where surfaces move across "
          .. "this direction: they stay sharp.",
        two = "Half of the taps along the dominant displacement (the longest one near the pixel), the others along the "
          .. "pixel's own displacement or, at static pixels, across the dominant one. Fails by halving the samples of each "
          .. "direction.",
      },
      breaks = { two = { reversed = every_other } } },
    tile         = blur.tile,
    limit        = blur.limit,
    depth_extent = blur.depth_extent,
    kappa        = pass.float { 40, min = 1e-3, max = 1e6,
      doc = "constant in the weight of the centre pixel, samples / (kappa * blur radius); larger values hide static pixels " ..
            "under blur" },
    gamma        = pass.float { 1.5, min = 1e-3, max = 1024, unit = "px",
      doc = "range of a pixel's blur radius where the second direction turns. Up to a radius of 1/2 px, the second " ..
            "direction is perpendicular to the dominant displacement. From a radius of 1/2 px plus this value on, the " ..
            "second direction is along the pixel's own displacement" },
    eta          = pass.float { 0.95, min = 0, max = 1, doc = "factor on the jitter of the sample times" },
    tile_jitter  = pass.choice { "none", "angle", "axis", default = "none", doc = "shift of the position that selects the " ..
        "tile of a pixel, and so the dominant displacement; hides the borders of tiles",
      values = {
        none = "Each pixel has the dominant displacement of its own tile. Fails by showing tile borders where the dominant "
          .. "displacement changes.",
        angle = "Each pixel has the dominant displacement of the tile at a point a quarter of a tile away, in a random "
          .. "direction. Fails with noise near tile borders, and where the displacement of that tile does not reach the pixel.",
        axis = "Each pixel has the dominant displacement of the tile at a point up to a quarter of a tile away, along x in "
          .. "every other tile, along y in the rest. Fails as `angle` does.",
      },
      breaks = {
        angle = { mirrored = stands, shifted = stands }, axis = { mirrored = stands, shifted = stands },
      } },
    jitter       = jitter.jitter,
    jitter_frame = jitter.jitter_frame,
    color_format = quantised.color_format,
  },
  counters = {
    color_clamped = quantised.counters.color_clamped,
    copied  = "pixels copied without blur, because no surface near them moves",
    uniform = "pixels with uniform motion around; all their taps count as moving by the dominant displacement",
  },
}
