-- SPDX-License-Identifier: MIT
-- Cells and time strata where the layers are unreliable.
local pass  = require "strobe.pass"
local blur  = require "passes.lib.blur"

local none = { 1e30, 1e30, -1e30, -1e30 }  -- bounds that contain no displacement: kNoBounds of lib/bounds.glsl

local function at_end(absent)
  return { absent = absent,
    doc = "per cell, least and greatest displacement, or path deviation, of surfaces visible only at shutter open or only " ..
          "at shutter close, as named by the port, px" }
end

local function background(absent)
  return { absent = absent,
    doc = "per cell, least and greatest displacement, or path deviation, of the unreliable texels of the revealed layer, " ..
          "as named by the port, px" }
end

return pass.compute {
  doc    = "Time strata of each cell that may contain a surface at a position that the layers do not describe",
  fails  = "The marks are conservative: extra cells around a cell with several motions may be marked. A surface whose path " ..
           "is not a parabola may leave the marked cells.",
  size   = { of = "bounds" },
  reads  = {
    bounds           = { doc = "bounds of the displacements of the unreliable texels in each cell, px over the exposure" },
    deviation_bounds = {
      doc = "bounds of the path deviations of the unreliable texels in each cell, at mid-exposure, px" },
    background_bounds    = background(none), background_deviation_bounds    = background(0),
    shutter_open_bounds  = at_end(none),     shutter_open_deviation_bounds  = at_end(0),
    shutter_close_bounds = at_end(none),     shutter_close_deviation_bounds = at_end(0),
  },
  updates = { unreliable = { format = "r32ui",
    doc = "bit i is set if an unreliable surface is in the cell in time stratum i of at most 32" } },
  params = {
    cell_side = blur.cell_side,
    limit     = blur.limit,
    samples   = blur.samples { doc = "number of time samples" },
    jittered  = pass.int { 0, min = 0, max = 1, wired = true,
      doc = "1 if jitter may move a sample anywhere within its time stratum" },
  },
}
