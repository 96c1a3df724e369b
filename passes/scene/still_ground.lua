-- SPDX-License-Identifier: MIT
-- Before a camera at rest, what is at rest behind what the capture sees in motion.
local pass  = require "strobe.pass"
local shade = require "passes.scene.shade"

return pass.trace {
  name   = "still_ground",
  shader = "scene/still_ground",
  doc    = "Where the capture sees something that moves, what is at rest behind it, before a camera at rest",
  fails  = "What is at rest is shaded as at the capture, with the shadows that it has then. Of what rests in one place with " ..
           "something that moves behind the first, nothing is found.",
  size   = { of = "hit" },
  reads  = {
    hit = { uint = true, doc = "what the capture sees: instance + 1 (0 = sky), geometry, primitive" },
  },
  writes = {
    ground = { format = "rgba32f", cleared = true,
      doc = "linear; alpha: linear view depth, metres, +inf without a surface; 0 where the capture sees what is at rest" },
  },
  without = { motion = { ground = 0 }, reached = { ground = 0 } },
  counters = {
    rays       = "pixels in which the capture sees what moves, and rays look behind it",
    not_finite = shade.counters.not_finite,
  },
}
