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
      doc = "at mid-exposure, offset of the surface from the straight line between the ends of its path, px" },
    nonlinear = { format = "r8_unorm",
      doc = "1 where the path leaves the curve by more than `max_deviation`, or the stretch exceeds `max_stretch`" },
    curve = { format = "rgba32f",
      doc = "xy: offset b of the parabola, px: at the fraction u of the exposure the path is 4 u (1 - u) b off the straight " ..
            "line between its ends. zw, for arcs: logarithm of the growth factor, and turn in radians, over the exposure" },
  },
  if_no = { motion = none, curves = none, depth = none },
  params = {
    velocity_format = quantised.velocity_format,
    trajectory = blur.trajectory,
    max_deviation = pass.float { 0.5, min = 0, max = 1000, unit = "px",
      doc = "largest distance of a true path from its curve" },
    max_stretch = pass.float { 1.5, min = 1, max = 1000, unit = "px",
      doc = "largest distance, within the exposure, of surface points that are one pixel apart at the raster time; at " ..
            "larger distances the taps of a filter leave holes" },
  },
  counters = { velocity_clamped = quantised.counters.velocity_clamped },
  fails  = "Parabolas fail for rotations beyond a sixth of a turn. Arcs fail beyond one and a quarter turns, and for " ..
           "circles seen obliquely.",
}
