-- SPDX-License-Identifier: MIT
-- Curved screen paths over the exposure, extrapolated from poses of earlier frames.
local pass       = require "strobe.pass"
local followed   = require "passes.lib.followed"
local quantised  = require "passes.lib.quantised"
local path_curve = require "passes.time.path_curve"

local straight = { velocity = "velocity", path_deviation = 0, nonlinear = 0, curve = 0 }

return pass.compute {
  doc    = "Parabolic screen paths of a layer's surfaces, through their positions in this frame and the two frames before it",
  size   = { of = "velocity" },
  scene  = true,
  reads  = followed,
  writes = {
    velocity = { format = quantised.velocity,
      doc = "displacement between the ends of the curve, px; a straight path keeps its displacement" },
    path_deviation = { format = quantised.velocity,
      doc = "at mid-exposure, offset of the surface from the straight line between the ends of its path, px" },
    nonlinear = { format = "r8_unorm",
      doc = "1 where the curve misses the true pose at shutter open or close by more than `max_deviation`, or the stretch " ..
            "exceeds `max_stretch`" },
    curve = { format = "rgba32f",
      doc = "offset b of the parabola, px: at the fraction u of the exposure the path is 4 u (1 - u) b off the straight " ..
            "line between its ends" },
  },
  if_no = { motion = straight, curves = straight },
  params = {
    velocity_format = quantised.velocity_format,
    max_deviation = path_curve.params.max_deviation,
    max_stretch   = path_curve.params.max_stretch,
  },
  counters = { velocity_clamped = quantised.counters.velocity_clamped },
  fails  = "A surface that changes direction after the raster time is extrapolated in the old direction. Errors of the " ..
           "poses are amplified more if the exposure extends farther beyond these poses. The curve is wrong in the first " ..
           "frames of a clip, because the frames before the clip count as static. A surface in the same position as one " ..
           "frame ago is treated as static.",
}
