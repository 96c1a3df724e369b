-- SPDX-License-Identifier: MIT
-- Time strata of each cell where the layers are unreliable: they may lack a surface, or store a wrong motion.
local pass  = require "strobe.pass"
local blur  = require "passes.lib.blur"

local none = { 1e30, 1e30, -1e30, -1e30 }  -- bounds that contain no displacement: kNoBounds of lib/bounds.glsl

local function at_end(absent)
  return { absent = absent,
    doc = "per cell, bounds of the surfaces visible only at shutter open, or only at shutter close: least and greatest " ..
          "displacement, or path deviation (ports with `deviation` in the name), px" }
end

local function background(absent)
  return { absent = absent,
    doc = "per cell, bounds of the unreliable texels of the revealed layer: least and greatest displacement, or path " ..
          "deviation (port with `deviation` in the name), px" }
end

return pass.compute {
  doc    = "Time strata of each cell in which the layers are unreliable: a surface may then be in the cell at a position " ..
           "that the layers do not describe. Rays are traced for the samples of these strata",
  fails  = "The marks are conservative: extra cells around a cell with several motions may be marked. A surface whose path " ..
           "is not a parabola may leave the marked cells.",
  size   = { of = "bounds" },
  reads  = {
    bounds           = { doc = "least and greatest displacement in each cell, px over the exposure, of the unreliable " ..
                               "texels: texels whose stored motion may be wrong" },
    deviation_bounds = {
      doc = "least and greatest path deviation in each cell, at mid-exposure, px, of the unreliable texels: texels whose " ..
            "stored motion may be wrong" },
    background_bounds    = background(none), background_deviation_bounds    = background(0),
    shutter_open_bounds  = at_end(none),     shutter_open_deviation_bounds  = at_end(0),
    shutter_close_bounds = at_end(none),     shutter_close_deviation_bounds = at_end(0),
  },
  updates = { unreliable = { format = "r32ui",
    doc = "bit i is set if the cell may contain a surface in time stratum i of at most 32 that the layers lack or store " ..
          "with a wrong motion" } },
  params = {
    cell_side = blur.cell_side,
    limit     = blur.limit,
    samples   = blur.samples { doc = "number of time samples" },
    jittered  = pass.int { 0, min = 0, max = 1, wired = true,
      doc = "1 if jitter may move a sample anywhere within its time stratum" },
  },
}
