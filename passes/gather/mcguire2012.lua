-- SPDX-License-Identifier: MIT
-- McGuire, Hennessy, Bukowski and Osman 2012, "A Reconstruction Filter for Plausible Motion Blur". The exposure may have any
-- position relative to the raster time (anchor).
local pass      = require "strobe.pass"
local blur      = require "passes.lib.blur"
local ports     = require "passes.lib.blur_ports"
local jitter    = require "passes.lib.jitter"
local quantised = require "passes.lib.quantised"

local every_other = "with an even number of samples, samples alternate between two directions from shutter open to shutter " ..
  "close; if time is reversed, each sample has the other direction"

return pass.compute {
  doc    = "Blur along the dominant displacement of the tile; taps are weighted by depth order, and by cone and cylinder " ..
           "functions of their distance",
  fails  = "Inside a moving silhouette, the foreground is too opaque (opacity 6/7 instead of 1/2, with a step at " ..
           "the silhouette), and the background is copied from outside. Coverage does not change linearly across an " ..
           "edge, and opacity grows with the number of samples. Surfaces that move across the dominant displacement " ..
           "are blurred along it.",
  breaks = {
    converging = "a moving object becomes more opaque with the number of samples, because the weight of the centre pixel " ..
      "stays the same",
  },
  size   = { of = "color" },
  reads  = ports.of_layer { "second" },
  writes = ports.layer,
  if_no = ports.no_motion,
  params = {
    samples      = blur.samples { doc = "number of taps along the dominant displacement" },
    directions   = blur.directions {
      values = {
        one = "All taps along the dominant displacement (the longest one near the pixel), as published. Fails where " ..
          "surfaces move across this direction: they are blurred along it.",
        two = "Half of the taps along the dominant displacement (the longest one near the pixel), the others along the "
          .. "pixel's own displacement or, at static pixels, across the dominant one. Fails by spreading surfaces across "
          .. "their motion, since weights depend on distances, not directions.",
      },
      breaks = { two = { reversed = every_other } } },
    tile         = blur.tile,
    limit        = blur.limit,
    depth_extent = blur.depth_extent,
    jitter       = jitter.jitter,
    jitter_frame = jitter.jitter_frame,
    color_format = quantised.color_format,
  },
  counters = { color_clamped = quantised.counters.color_clamped },
}
