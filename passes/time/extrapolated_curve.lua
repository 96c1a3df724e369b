-- SPDX-License-Identifier: MIT
-- Curved screen paths over the exposure, extrapolated from poses of earlier frames.
local pass      = require "strobe.pass"
local followed  = require "passes.lib.followed"
local quantised = require "passes.lib.quantised"

local straight = { velocity = "velocity", curve = 0 }

return pass.compute {
  doc    = "Parabolic screen paths of a layer's surfaces, through their positions in this frame and the two frames before it",
  size   = { of = "velocity" },
  scene  = true,
  reads  = {
    depth = followed.depth, id = followed.id, hit = followed.hit,
    velocity = { doc = "screen displacement of the surface, computed from the previous frame alone, px over the exposure" },
  },
  writes = {
    velocity = { format = quantised.velocity,
      doc = "displacement of the surface along its curve from shutter open to shutter close, px; for a straight path, the " ..
            "displacement of the input `velocity`" },
    curve = { format = "rgba32f",
      doc = "offset b of the parabola, at mid-exposure, from the straight line between its ends, px. At the fraction u of " ..
            "the exposure the offset is 4 u (1 - u) b" },
  },
  if_no = { motion = straight, curves = straight },
  params = { velocity_format = quantised.velocity_format },
  counters = { velocity_clamped = quantised.counters.velocity_clamped },
  fails  = "A surface that changes direction after the raster time is extrapolated in the old direction. Errors of the " ..
           "earlier poses are amplified, the more so the farther the exposure extends beyond these poses. The curve is " ..
           "wrong in the first frames of a clip, because the frames before the clip count as static. A surface whose " ..
           "position equals its position one frame ago is treated as static.",
}
