-- SPDX-License-Identifier: MIT
-- How paths are curved over the exposure, as poses of earlier frames foretell it.
local pass       = require "strobe.pass"
local followed   = require "passes.lib.followed"
local stored     = require "passes.lib.stored"
local path_curve = require "passes.scene.path_curve"

local straight = { velocity = "velocity", bend = 0, bent = 0, curve = 0 }

return pass.compute {
  name   = "earlier_curve",
  shader = "scene/earlier_curve",
  doc    = "Parabolas for the paths of the surfaces of a layer, through their places in this frame and the two before it",
  size   = { of = "velocity" },
  scene  = true,
  reads  = followed,
  writes = {
    velocity = { format = stored.velocity, doc = "px between the ends of the curve; what is straight keeps its own" },
    bend = { format = stored.velocity, doc = "px in the middle of the exposure" },
    bent = { format = "r8_unorm", doc = "1 where an end of the exposure is not where the curve has it; true poses tell" },
    curve = { format = "rgba32f", doc = "px: b; the path is 4 u (1 - u) b away from its line" },
  },
  without = { motion = straight, curves = straight },
  params = {
    velocity_format = stored.velocity_format,
    most_bend   = path_curve.params.most_bend,
    most_growth = path_curve.params.most_growth,
  },
  counters = { velocity_clamped = stored.counters.velocity_clamped },
  fails  = "What changes its way after the capture goes on as before; the farther the exposure reaches beyond the poses, " ..
    "the more an error of theirs counts. At the first frames of a clip, whose earlier ones stand still. What is where it " ..
    "was one frame ago is taken to be at rest.",
}
