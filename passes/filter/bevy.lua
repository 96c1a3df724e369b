-- SPDX-License-Identifier: MIT
-- The motion blur of the Bevy engine (2024), for any anchor: each pixel along its own displacement.
local pass   = require "strobe.pass"
local blur   = require "passes.lib.blur"
local ports  = require "passes.lib.blur_ports"
local jitter = require "passes.lib.jitter"

return pass.compute {
  name   = "bevy",
  shader = "filter/bevy",
  doc    = "Blur of each pixel along its own displacement; nearer taps count if they move as far as the pixel is away",
  fails  = "Nothing blurs beyond its silhouette: a pixel at rest stays as it is whatever passes over it. Inside, the "
    .. "background is the picture from outside. Nearer things that move along the same line count although they never "
    .. "come to the pixel, since which way they go is not asked.",
  size   = { of = "color" },
  reads  = ports.of { "color", "depth", "velocity" },
  writes = ports.picture,
  without = ports.still,
  params = {
    samples      = blur.samples { doc = "taps along the displacement" },
    limit        = blur.limit,
    copy_below   = pass.float { 1, min = 0, max = 16, unit = "px",
      doc = "a pixel that moves less than this over the exposure is copied, as is one that moves half a pixel or less" },
    jitter       = jitter.jitter,
    jitter_frame = jitter.jitter_frame,
  },
  counters = {
    clamped = {
      doc   = "pixels that move farther than the limit",
      limit = "the filter shortened their displacement to the limit: their blur is shorter than it should be, which truth " ..
              "does not share. Raise `limit`, or shorten the exposure",
    },
    copied = "pixels that were copied, since they do not move",
  },
}
