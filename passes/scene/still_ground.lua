-- SPDX-License-Identifier: MIT
-- Before a camera at rest, what is at rest on each pixel's ray: what the capture sees, or what is behind that where it moves.
local pass  = require "strobe.pass"
local shade = require "passes.scene.shade"

return pass.trace {
  name   = "still_ground",
  shader = "scene/still_ground",
  doc    = "What is at rest on each pixel's ray, before a camera at rest; else what the capture sees",
  fails  = "What is at rest is shaded as at the capture, with the shadows that it has then.",
  size   = { of = "hit" },
  reads  = {
    hit   = { uint = true, doc = "what the capture sees: instance + 1 (0 = sky), geometry, primitive" },
    color = { doc = "linear, of that" },
    depth = { doc = "its linear view depth, metres; sky = +inf" },
  },
  writes = { ground = { format = "rgba32f", doc = "linear; alpha: linear view depth, metres, +inf without a surface" } },
  without = { motion = { ground = "color" } },
  counters = {
    rays       = "pixels in which the capture sees what moves, and rays look behind it",
    not_finite = shade.counters.not_finite,
  },
}
