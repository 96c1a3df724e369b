-- SPDX-License-Identifier: MIT
-- What an end of the exposure sees and no layer of the capture holds: the description of a pass.
local param  = require "strobe.param"
local stored = require "passes.lib.stored"

-- `end_of`: "start" or "end"; `fact`: that the exposure has a part before, or after, the capture.
return function(name, end_of, fact)
  local nothing = { unseen = 0, velocity = 0, bend = 0 }
  return {
    name   = name,
    shader = "scene/unseen",
    doc    = ("What moves and the %s of the exposure sees, that neither the capture nor its rays have found"):format(end_of),
    size   = { of = "hit" },
    scene  = true,
    reads  = {
      hit   = { uint = true, doc = "of that end: instance + 1, geometry, primitive; 0 = sky, or what is at rest" },
      depth = { doc = "of the capture: linear view depth, metres; sky = +inf" },
      id    = { uint = true, doc = "of the capture: instance + 1; sky = 0" },
      revealed_depth = { doc = "of what was revealed behind it: linear view depth, metres; sky = +inf" },
      revealed_id    = { uint = true, doc = "its instance + 1; sky = 0" },
      revealed_valid = { doc = "above 1/2 where something was revealed" },
    },
    writes = {
      unseen   = { format = "r8_unorm", cleared = true, doc = "1 where no layer of the capture holds what is seen and moves" },
      velocity = { format = stored.velocity, cleared = true, doc = "displacement over the exposure of what is seen, px" },
      bend     = { format = stored.velocity, cleared = true,
        doc = "how far its path is from a line, px in the middle of the exposure" },
    },
    without = { motion = nothing, arrives = nothing, reached = nothing, [fact] = nothing },
    params = {
      velocity_format = stored.velocity_format,
      same_depth = param.float { 0.01, min = 0, max = 1, doc = "share of the depth over which two depths count as one" },
    },
    counters = { velocity_clamped = stored.counters.velocity_clamped },
    fails  = "A surface that comes out and goes in again between the ends of the exposure is not known to either.",
  }
end
