-- SPDX-License-Identifier: MIT
-- Where paths over the exposure are no straight lines.
local pass     = require "strobe.pass"
local followed = require "passes.lib.followed"
local stored   = require "passes.lib.stored"

return pass.compute {
  name   = "path_bend",
  shader = "scene/path_bend",
  doc    = "Where the surfaces of a layer leave the straight line between the ends of their paths",
  size   = { of = "velocity" },
  scene  = true,
  reads  = followed,
  writes = {
    bend = { format = stored.velocity, cleared = true, doc = "px in the middle of the exposure" },
    bent = { format = "r8_unorm", cleared = true, doc = "1 where the path is farther from a line than that" },
  },
  without = { motion = { bend = 0, bent = 0 }, curves = { bend = 0, bent = 0 }, reached = { bend = 0, bent = 0 } },
  params = {
    velocity_format = stored.velocity_format,
    most_bend = pass.float { 0.5, min = 0, max = 1000, unit = "px",
      doc = "how far a path may be from the line between its ends, in the middle of the exposure" },
    most_growth = pass.float { 1.5, min = 1, max = 1000, unit = "px",
      doc = "to how much a side of a pixel of a surface may grow; a filter's taps have holes beyond" },
  },
  counters = { velocity_clamped = stored.counters.velocity_clamped },
  fails  = "A path that swings to and fro within half of the exposure is taken for a line.",
}
