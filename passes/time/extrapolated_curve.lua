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
      doc = "displacement of the surface along its curve from shutter open to shutter close, px; for a straight path, the " ..
            "displacement of the input `velocity`" },
    path_deviation = { format = quantised.velocity,
      doc = "offset of the surface, at mid-exposure, from the straight line between the ends of its screen path, px" },
    nonlinear = { format = "r8_unorm",
      doc = "1 where the curve misses the true position at shutter open or close by more than `max_deviation` px, or where " ..
            "surface points one pixel apart at the raster time are then more than `max_stretch` px apart; otherwise 0" },
    curve = { format = "rgba32f",
      doc = "offset b of the parabola, at mid-exposure, from the straight line between its ends, px. At the fraction u of " ..
            "the exposure the offset is 4 u (1 - u) b" },
  },
  if_no = { motion = straight, curves = straight },
  params = {
    velocity_format = quantised.velocity_format,
    max_deviation = path_curve.params.max_deviation,
    max_stretch   = path_curve.params.max_stretch,
  },
  counters = { velocity_clamped = quantised.counters.velocity_clamped },
  fails  = "A surface that changes direction after the raster time is extrapolated in the old direction. Errors of the " ..
           "earlier poses are amplified, the more so the farther the exposure extends beyond these poses. The curve is " ..
           "wrong in the first frames of a clip, because the frames before the clip count as static. A surface whose " ..
           "position equals its position one frame ago is treated as static.",
}
