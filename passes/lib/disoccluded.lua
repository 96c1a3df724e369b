-- SPDX-License-Identifier: MIT
-- Description of a pass that finds moving surfaces visible at shutter open or shutter close but missing in both layers.
local param     = require "strobe.param"
local quantised = require "passes.lib.quantised"

-- `end_of`: "start" or "end" of the exposure. `fact`: the fact that the exposure has a part before, or after, the raster time.
return function(end_of, fact)
  local nothing = { disoccluded = 0, velocity = 0, path_deviation = 0 }
  return {
    shader = "time/disoccluded",
    doc    = ("Moving surfaces visible at the %s of the exposure that neither layer of the raster time has"):format(end_of),
    size   = { of = "hit" },
    scene  = true,
    reads  = {
      hit   = { uint = true,
        doc = "surface visible at one end of the exposure: instance + 1, geometry, primitive; 0 for sky or a static surface" },
      depth = { doc = "linear view depth of the raster layer, metres; +inf for the sky" },
      id    = { uint = true, doc = "instance + 1 of the raster layer; 0 for the sky" },
      revealed_depth = { doc = "linear view depth of the revealed surface, metres; +inf for the sky" },
      revealed_id    = { uint = true, doc = "instance + 1 of the revealed surface; 0 for the sky" },
      revealed_valid = { doc = "mask, above 1/2 where a surface was revealed" },
    },
    writes = {
      disoccluded = { format = "r8_unorm", cleared = true, doc = "1 where both layers lack the visible moving surface" },
      velocity    = { format = quantised.velocity, cleared = true,
        doc = "displacement of the visible surface, px over the exposure" },
      path_deviation     = { format = quantised.velocity, cleared = true,
        doc = "path deviation of the visible surface from a straight line in the middle of the exposure, px" },
    },
    if_no = { motion = nothing, may_appear = nothing, moving_rect = nothing, [fact] = nothing },
    params = {
      velocity_format = quantised.velocity_format,
      same_depth = param.float { 0.01, min = 0, max = 1,
        doc = "relative tolerance for equal depths" },
    },
    counters = { velocity_clamped = quantised.counters.velocity_clamped },
    fails  = "Surfaces that appear after shutter open and disappear before shutter close are missed.",
  }
end
