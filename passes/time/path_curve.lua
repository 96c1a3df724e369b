-- SPDX-License-Identifier: MIT
-- Curved screen paths over the exposure, and the texels where the curve is unreliable.
local pass      = require "strobe.pass"
local blur      = require "passes.lib.blur"
local followed  = require "passes.lib.followed"
local quantised = require "passes.lib.quantised"

local none = { path_deviation = 0, nonlinear = 0, curve = 0 }

return pass.compute {
  doc    = "Parabolic or arc-shaped screen paths of a layer's surfaces, through poses within the exposure",
  size   = { of = "velocity" },
  scene  = true,
  reads  = followed,
  writes = {
    path_deviation = { format = quantised.velocity,
      doc = "path deviation from a straight line in the middle of the exposure, px" },
    nonlinear = { format = "r8_unorm",
      doc = "1 where the path leaves the curve by more than `max_deviation`, or the stretch exceeds `max_stretch`" },
    curve = { format = "rgba32f",
      doc = "xy: offset b of the parabola, px: at the fraction u of the exposure the path is 4 u (1 - u) b off its straight " ..
            "line; zw, of arcs: logarithm of the growth factor, and turn in radians, over the exposure" },
  },
  if_no = { motion = none, curves = none, depth = none },
  params = {
    velocity_format = quantised.velocity_format,
    trajectory = blur.trajectory,
    max_deviation = pass.float { 0.5, min = 0, max = 1000, unit = "px",
      doc = "largest distance of the path from the curve" },
    max_stretch = pass.float { 1.5, min = 1, max = 1000, unit = "px",
      doc = "largest distance of adjacent texels of a surface after stretching; beyond it the taps of a filter leave holes" },
  },
  counters = { velocity_clamped = quantised.counters.velocity_clamped },
  fails  = "Parabolas fail beyond a sixth of a turn. Arcs fail beyond one and a quarter turns, and for circles seen obliquely.",
}
