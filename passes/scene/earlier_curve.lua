-- SPDX-License-Identifier: MIT
-- Curved screen paths over the exposure, extrapolated from poses of earlier frames.
local pass       = require "strobe.pass"
local followed   = require "passes.lib.followed"
local stored     = require "passes.lib.stored"
local path_curve = require "passes.scene.path_curve"

local straight = { velocity = "velocity", bend = 0, bent = 0, curve = 0 }

return pass.compute {
  name   = "earlier_curve",
  shader = "scene/earlier_curve",
  doc    = "Parabolic screen paths of a layer's surfaces, through their positions in this frame and the two frames before it",
  size   = { of = "velocity" },
  scene  = true,
  reads  = followed,
  writes = {
    velocity = { format = stored.velocity,
      doc = "displacement between the ends of the curve, px; a straight path keeps its displacement" },
    bend = { format = stored.velocity, doc = "path deviation from a straight line in the middle of the exposure, px" },
    bent = { format = "r8_unorm",
      doc = "1 where the curve misses the true pose at shutter open or close by more than `most_bend`, or the stretch " ..
            "exceeds `most_growth`" },
    curve = { format = "rgba32f",
      doc = "offset b of the parabola, px: at the fraction u of the exposure the path is 4 u (1 - u) b off its straight " ..
            "line" },
  },
  without = { motion = straight, curves = straight },
  params = {
    velocity_format = stored.velocity_format,
    most_bend   = path_curve.params.most_bend,
    most_growth = path_curve.params.most_growth,
  },
  counters = { velocity_clamped = stored.counters.velocity_clamped },
  fails  = "A surface that changes direction after the raster time continues as before. Errors of the poses are amplified " ..
           "the farther the exposure extends beyond them. Wrong in the first frames of a clip, whose earlier frames are " ..
           "static. A surface in the same position as one frame ago is treated as static.",
}
