-- SPDX-License-Identifier: MIT
-- How paths are curved over the exposure, as poses of earlier frames foretell it.
local pass       = require "strobe.pass"
local blur       = require "passes.lib.blur"
local stored     = require "passes.lib.stored"
local path_curve = require "passes.scene.path_curve"

local straight = { velocity = "velocity", bend = 0, bent = 0, curve = 0 }

return pass.compute {
  name   = "earlier_curve",
  shader = "scene/earlier_curve",
  doc    = "Polynomials in time for the paths of the surfaces of a layer, through their places in this frame and earlier ones",
  size   = { of = "velocity" },
  scene  = true,
  reads  = {
    depth    = { doc = "linear view depth, metres; sky = +inf, 0 where the layer has nothing" },
    id       = { uint = true, doc = "instance + 1 (0 = sky)" },
    velocity = { doc = "displacement over the exposure, px, as the frame before foretells it" },
    hit      = { optional = true, uint = true,
      doc = "instance + 1 (0 = sky), geometry, primitive; absent: joints and morph targets are not followed" },
    normal   = { optional = true, doc = "unit, world space; sky = 0; absent: growth is not looked at" },
  },
  writes = {
    velocity = { format = stored.velocity, doc = "px between the ends of the curve; what is straight keeps its own" },
    bend = { format = stored.velocity, doc = "px in the middle of the exposure" },
    bent = { format = "r8_unorm", doc = "1 where an end of the exposure is not where the curve has it; true poses tell" },
    curve = { format = "rgba32f", doc = "px: b and c of 4 u (1 - u) (b + (2u - 1) c), by which a path leaves its line" },
  },
  without = { motion = straight, curves = straight },
  params = {
    velocity_format = stored.velocity_format,
    trajectory  = blur.trajectory,
    most_bend   = path_curve.params.most_bend,
    most_growth = path_curve.params.most_growth,
  },
  counters = { velocity_clamped = stored.counters.velocity_clamped },
  fails  = "What changes its way after the capture goes on as before; the farther the exposure reaches beyond the poses, " ..
    "the more an error of theirs counts. At the first frames of a clip, whose earlier ones stand still. What is where it " ..
    "was one frame ago is taken to be at rest.",
}
