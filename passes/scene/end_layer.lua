-- SPDX-License-Identifier: MIT
-- A layer from another time than the capture's: what an end of the exposure alone sees.
local pass   = require "strobe.pass"
local shade  = require "passes.scene.shade"
local stored = require "passes.lib.stored"

return pass.trace {
  name   = "end_layer",
  shader = "scene/end_layer",
  doc    = "Colour and depth of what an end of the exposure sees and no layer of the capture holds",
  size   = { of = "hit" },
  reads  = {
    hit    = { uint = true, doc = "of that end: instance + 1, geometry, primitive; 0 = sky" },
    unseen = { doc = "above 1/2 where no layer of the capture holds what is seen there" },
  },
  writes = {
    color = { format = stored.color, doc = "linear radiance, shaded as at the capture; 0 elsewhere" },
    depth = { format = "r32f", doc = "linear view depth at that end, metres; sky = +inf, 0 elsewhere" },
  },
  without = { unseen = { color = 0, depth = 0 } },
  params = {
    end_of = pass.choice { "start", "finish", default = "start", doc = "which end of the exposure `hit` is of" },
    color_format = stored.color_format,
  },
  counters = {
    not_finite    = shade.counters.not_finite,
    color_clamped = stored.counters.color_clamped,
  },
  fails  = "A point in shadow at the capture is in shadow at all times, as everywhere.",
}
