-- SPDX-License-Identifier: MIT
-- Rays in time, more of them where what a pixel sees changes; none where a gather is certain.
local pass  = require "strobe.pass"
local blur  = require "passes.lib.blur"
local shade = require "passes.scene.shade"

return pass.trace {
  name   = "refined_time",
  shader = "scene/refined_time",
  doc    = "For each pixel in which no gather is certain, rays at a few times, and between two that differ at further times",
  breaks = { linear = "which times have a ray is decided by how much colours differ" },
  size   = { of = "color" },
  reads  = {
    color    = { doc = "linear, of what the capture sees" },
    depth    = { doc = "its linear view depth, metres; sky = +inf" },
    id       = { uint = true, doc = "its instance + 1, geometry + 1; sky = 0" },
    hit      = { uint = true, doc = "what it is: instance + 1 (0 = sky), geometry, primitive" },
    velocity = { doc = "its displacement over the exposure, px" },
    certain  = { doc = "per cell, 1 where a gather along that is right, 1/2 where nothing moves, else 0" },
    longest  = { doc = "per cell, longest displacement of what comes there, px over the exposure" },
  },
  writes = { picture = { format = "rgba32f", doc = "linear; alpha 1" } },
  without = { motion = { picture = "color" } },
  params = {
    cell_side = blur.cell_side,
    samples   = blur.samples { doc = "taps along the motion where a gather is certain" },
    pace      = pass.float { 0.02, min = 1e-6, max = 1e6, unit = "image widths",
      doc = "how far what comes to a cell may go from one of the first rays to the next" },
    allowance = pass.float { 0.01, min = 0, max = 1000,
      doc = "linear radiance: what two rays do not foretell of the time between them, times its share of the exposure, " ..
            "that is let be" },
    hit_color = pass.choice { "shaded", "kept", default = "shaded", doc = "what colour the hit of a ray has",
      values = {
        shaded = "It is shaded, as it is at the capture.",
        kept = "That of the texel of the capture that shows it, else it is shaded. Fails by half a pixel: stairs in textures.",
      } },
    same_depth = pass.float { 0.01, min = 0, max = 1, doc = "share of the depth over which two depths count as one" },
  },
  counters = {
    gathered   = "pixels that took what is known of the capture, without a ray",
    samples    = "samples of the others that had a ray",
    not_finite = shade.counters.not_finite,
  },
  fails  = "What comes and goes between two rays that see alike is missed.",
}
