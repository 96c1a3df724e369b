-- SPDX-License-Identifier: MIT
-- Guertin, McGuire and Nowrouzezahrai 2014, "A Fast and Stable Feature-Aware Motion Blur Filter", for any anchor.
local pass   = require "strobe.pass"
local blur   = require "passes.lib.blur"
local ports  = require "passes.lib.blur_ports"
local jitter = require "passes.lib.jitter"
local stored = require "passes.lib.stored"

local every_other = "of an even number of samples to both sides every other one is taken, counted from one end, as published"
local stands = "which tile a pixel looks in is drawn on the screen: that is neither mirrored nor moved with what is seen"

return pass.compute {
  name   = "gather_guertin2014",
  shader = "gather/guertin2014",
  doc    = "Blur along the dominant displacement and a second direction, weighed by how motions are aligned with them",
  fails  = "Like McGuire's filter it is too opaque inside silhouettes, its ramps are no straight lines and the "
    .. "background in them is the picture from outside. Things that move along neither of the two directions stay "
    .. "sharp or leave noise, and half of the samples see each direction.",
  size   = { of = "color" },
  reads  = ports.of_layer({ "second", "slowest" }, {
    variance = { optional = true, doc = "0 (alike) to 1, of directions, per tile; absent: half of the samples" },
  }),
  writes = ports.layer,
  without = ports.still,
  params = {
    samples      = blur.samples { doc = "taps along both directions together" },
    directions   = blur.directions { default = "two",
      values = {
        one = "All along the dominant displacement. Fails where things cross it: they stay sharp.",
        two = "Every other one along a second direction: the pixel's own, or across the dominant one where the pixel "
          .. "is at rest. Fails by halving the samples of each.",
      },
      breaks = { two = { reversed = every_other } } },
    tile         = blur.tile,
    limit        = blur.limit,
    depth_extent = blur.depth_extent,
    kappa        = pass.float { 40, min = 1e-3, max = 1e6,
      doc = "the pixel itself weighs samples / (kappa * its radius): larger hides what is at rest under blur" },
    gamma        = pass.float { 1.5, min = 1e-3, max = 1024, unit = "px",
      doc = "radius above 1/2 px at which the second direction has become the pixel's own" },
    eta          = pass.float { 0.95, min = 0, max = 1, doc = "share of the jitter that is used" },
    tile_jitter  = pass.choice { "none", "angle", "axis", default = "none", doc = "in which tile a pixel looks",
      values = {
        none = "In its own. Fails with borders of tiles that show where the dominant displacement changes.",
        angle = "In that of a point a quarter of a tile away, in a direction of its own. Fails as noise near borders, "
          .. "and where the other tile's displacement does not reach this one.",
        axis = "In that of a point up to a quarter of a tile away, sideways or up and down by tile. Fails as angle.",
      },
      breaks = {
        angle = { mirrored = stands, shifted = stands }, axis = { mirrored = stands, shifted = stands },
      } },
    jitter       = jitter.jitter,
    jitter_frame = jitter.jitter_frame,
    color_format = stored.color_format,
  },
  counters = {
    color_clamped = stored.counters.color_clamped,
    copied  = "pixels that were copied, since nothing around moves",
    uniform = "pixels at which all around was taken to move alike",
  },
}
