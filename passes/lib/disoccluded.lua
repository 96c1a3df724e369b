-- SPDX-License-Identifier: MIT
-- Description of a pass that finds moving surfaces visible at shutter open or shutter close but missing in both layers.
local param     = require "strobe.param"
local quantised = require "passes.lib.quantised"

-- Returns the description of the pass. `end_of`: the tested end of the exposure, "start" or "end". `fact`: "before" or "after",
-- the fact that the exposure has a part before, or after, the raster time.
return function(end_of, fact)
  local nothing = { disoccluded = 0, velocity = 0, path_deviation = 0 }
  return {
    shader = "time/disoccluded",
    doc    = ("Moving surfaces that are visible at the %s of the exposure, but are in neither layer"):format(end_of),
    size   = { of = "hit" },
    scene  = true,
    reads  = {
      hit   = { uint = true,
        doc = "surface visible at the tested end of the exposure, by indices: instance + 1, geometry, triangle; 0 for the " ..
              "sky or a static surface" },
      depth = { doc = "linear view depth of the raster layer, metres; +inf for the sky" },
      id    = { uint = true, doc = "instance index + 1 of the raster layer; 0 for the sky" },
      revealed_depth = { doc = "linear view depth of the surface revealed behind the raster layer, metres; +inf for the sky" },
      revealed_id    = { uint = true, doc = "instance index + 1 of the surface revealed behind the raster layer; 0 for the " ..
                                            "sky" },
      revealed_valid = { doc = "mask, above 1/2 where a ray revealed a surface behind the raster layer" },
    },
    writes = {
      disoccluded = { format = "r8_unorm", cleared = true, doc = "1 where the visible moving surface is in neither layer" },
      velocity    = { format = quantised.velocity, cleared = true,
        doc = "screen displacement of the visible surface, px over the exposure" },
      path_deviation     = { format = quantised.velocity, cleared = true,
        doc = "offset of the visible surface, at mid-exposure, from the straight line between the ends of its screen path, " ..
              "px" },
    },
    if_no = { motion = nothing, may_appear = nothing, moving_rect = nothing, [fact] = nothing },
    params = {
      velocity_format = quantised.velocity_format,
      same_depth = param.float { 0.01, min = 0, max = 1,
        doc = "largest relative difference between the depth of a hit point and the depth of a texel that shows this point" },
    },
    counters = { velocity_clamped = quantised.counters.velocity_clamped },
    fails  = "Surfaces that appear after shutter open and disappear before shutter close are missed.",
  }
end
