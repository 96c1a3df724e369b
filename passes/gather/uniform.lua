-- SPDX-License-Identifier: MIT
-- Time-uniform gather with N taps. A tap counts if its own motion passes over the pixel. Its weight is then 1/N of the
-- exposure, or more if its surface is slower than the dominant motion and so covers the pixel for a longer time.
local pass      = require "strobe.pass"
local blur      = require "passes.lib.blur"
local ports     = require "passes.lib.blur_ports"
local jitter    = require "passes.lib.jitter"
local quantised = require "passes.lib.quantised"

return pass.compute {
  doc    = "Blur along the dominant displacement of the tile; each tap stands for an equal fraction of the exposure, and " ..
           "counts if its surface passes over the pixel",
  fails  = "Without a revealed layer the background inside a silhouette is copied from outside. If the background moves under "
    .. "a moving silhouette, mean coverage times mean background colour differs from the mean of their product over the "
    .. "exposure. Surfaces whose path is more than 3/4 px off the line of the dominant displacement are not found.",
  size   = { of = "color" },
  reads  = ports.of_layer { "velocity_post", "dominant_post" },
  writes = ports.layer,
  if_no = ports.no_motion,
  params = {
    samples      = blur.samples { doc = "number of taps along the dominant displacement" },
    tile         = blur.tile,
    limit        = blur.limit,
    depth_extent = blur.depth_extent,
    jitter       = jitter.jitter,
    jitter_frame = jitter.jitter_frame,
    color_format = quantised.color_format,
  },
  counters = { color_clamped = quantised.counters.color_clamped },
}
