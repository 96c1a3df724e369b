-- SPDX-License-Identifier: MIT
-- Stand-in for the post-process motion blur of game engines around 2020: Jimenez 2014, with mirrored background.
local pass = require "strobe.pass"

return pass.compute {
  name   = "gather_ue4",
  shader = "gather/ue4",
  doc    = "Blur in pairs of taps whose nearer and faster side weighs both",
  size   = { of = "color" },
  reads  = {
    color    = { doc = "linear" },
    depth    = { doc = "linear view depth, metres, sky = +inf" },
    velocity = { doc = "px over the exposure" },
    dominant = { doc = "px over the exposure, per tile" },
  },
  writes = { blurred = { format = "rgba32f", doc = "linear; alpha 1" } },
  params = {
    samples      = pass.int { 16, min = 1, max = 1024, doc = "taps along the displacement" },
    tile         = pass.int { 16, min = 1, max = 1024, unit = "px", doc = "side of a tile" },
    limit        = pass.float { 0.05, min = 0, max = 10, unit = "image widths", doc = "longest displacement handled" },
    depth_extent = pass.float { 0.01, min = 1e-6, max = 1, doc = "share of the depth over which order is undecided" },
    mirror       = pass.bool { true, doc = "the nearer and faster tap of a pair gives both their weight" },
    jitter       = pass.choice { "none", "ign", "hash", default = "none",
      doc = "shift of the taps by up to half a step: none, interleaved gradient noise, or by the seed" },
  },
}
