-- SPDX-License-Identifier: MIT
-- How paths over the exposure are curved, and where that does not say where they go.
local pass     = require "strobe.pass"
local blur     = require "passes.lib.blur"
local followed = require "passes.lib.followed"
local stored   = require "passes.lib.stored"

return pass.compute {
  name   = "path_curve",
  shader = "scene/path_curve",
  doc    = "Parabolas, or arcs, for the paths of the surfaces of a layer, through poses inside of the exposure",
  size   = { of = "velocity" },
  scene  = true,
  reads  = followed,
  writes = {
    bend = { format = stored.velocity, doc = "px in the middle of the exposure" },
    bent = { format = "r8_unorm", doc = "1 where the curve does not say where the surface is" },
    curve = { format = "rgba32f", doc = "px: b; the path is 4 u (1 - u) b away from its line; " ..
      "for arcs also the logarithm of a factor and radians by which it grows and turns over the exposure" },
  },
  without = { motion = { bend = 0, bent = 0, curve = 0 }, curves = { bend = 0, bent = 0, curve = 0 },
    depth = { bend = 0, bent = 0, curve = 0 } },
  params = {
    velocity_format = stored.velocity_format,
    trajectory = blur.trajectory,
    most_bend = pass.float { 0.5, min = 0, max = 1000, unit = "px",
      doc = "how far the path may be from the curve" },
    most_growth = pass.float { 1.5, min = 1, max = 1000, unit = "px",
      doc = "to how much a side of a pixel of a surface may grow; a filter's taps have holes beyond" },
  },
  counters = { velocity_clamped = stored.counters.velocity_clamped },
  fails  = "Parabolas beyond a sixth of a turn; arcs beyond one and a quarter turns, and for circles seen aslant.",
}
