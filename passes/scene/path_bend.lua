-- SPDX-License-Identifier: MIT
-- Path deviation over the exposure from a straight line.
local pass     = require "strobe.pass"
local followed = require "passes.lib.followed"
local stored   = require "passes.lib.stored"

return pass.compute {
  name   = "path_bend",
  shader = "scene/path_bend",
  doc    = "Path deviation of a layer's surfaces from the straight line between their positions at shutter open and close",
  size   = { of = "velocity" },
  scene  = true,
  reads  = followed,
  writes = {
    bend = { format = stored.velocity, cleared = true,
      doc = "path deviation from a straight line in the middle of the exposure, px" },
    bent = { format = "r8_unorm", cleared = true,
      doc = "1 where the path deviation exceeds `most_bend`, or the stretch exceeds `most_growth`" },
  },
  without = { motion = { bend = 0, bent = 0 }, curves = { bend = 0, bent = 0 }, reached = { bend = 0, bent = 0 } },
  params = {
    velocity_format = stored.velocity_format,
    most_bend = pass.float { 0.5, min = 0, max = 1000, unit = "px",
      doc = "largest path deviation from a straight line in the middle of the exposure" },
    most_growth = pass.float { 1.5, min = 1, max = 1000, unit = "px",
      doc = "largest distance of adjacent texels of a surface after stretching; beyond it the taps of a filter leave holes" },
  },
  counters = { velocity_clamped = stored.counters.velocity_clamped },
  fails  = "A path that crosses its straight line in the middle of the exposure, such as a fast oscillation, is treated as " ..
           "straight.",
}
