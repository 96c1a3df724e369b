-- SPDX-License-Identifier: MIT
-- Curved screen paths over the exposure, and the texels where the curve is unreliable.
local pass      = require "strobe.pass"
local blur      = require "passes.lib.blur"
local followed  = require "passes.lib.followed"
local quantised = require "passes.lib.quantised"

local none = { path_deviation = 0, nonlinear = 0, curve = 0 }

return pass.compute {
  doc    = "Parabolas or arcs fitted to the screen paths of a layer's surfaces, through true poses within the exposure",
  size   = { of = "velocity" },
  scene  = true,
  reads  = followed,
  writes = {
    path_deviation = { format = quantised.velocity,
      doc = "offset of the surface, at mid-exposure, from the straight line between the ends of its screen path, px" },
    nonlinear = { format = "r8_unorm",
      doc = "1 where the true path leaves the curve by more than `max_deviation` px, or where surface points one pixel " ..
            "apart at the raster time are more than `max_stretch` px apart at shutter open or close; otherwise 0" },
    curve = { format = "rgba32f",
      doc = "xy: offset b of the curve, at mid-exposure, from the straight line between its ends, px. At the fraction u of " ..
            "the exposure, the offset of a parabola is 4 u (1 - u) b. zw, for arcs only: logarithm of the growth factor, " ..
            "and turn in radians, over the exposure" },
  },
  if_no = { motion = none, curves = none, depth = none },
  params = {
    velocity_format = quantised.velocity_format,
    trajectory = blur.trajectory,
    max_deviation = pass.float { 0.5, min = 0, max = 1000, unit = "px",
      doc = "largest distance of a true path from its fitted curve; a path that deviates more is marked as nonlinear" },
    max_stretch = pass.float { 1.5, min = 1, max = 1000, unit = "px",
      doc = "largest distance, within the exposure, of surface points that are one pixel apart at the raster time; at " ..
            "larger distances the taps of a filter leave holes" },
  },
  counters = { velocity_clamped = quantised.counters.velocity_clamped },
  fails  = "Parabolas fail if the object rotates by more than a sixth of a turn within the exposure. Arcs fail beyond one " ..
           "and a quarter turns, and for circles seen obliquely.",
}
