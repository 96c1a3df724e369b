-- SPDX-License-Identifier: MIT
-- Of the displacements around, those by which something may be uncovered; third step of the relative mask.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"
local path = require "passes.lib.relative_path"
local reach = require "passes.lib.reach"

local function pair(doc) return { format = "rgba32f", doc = doc } end

local motions = { doc = "two displacements per tile, px over the exposure; 1e9 = none" }

return pass.compute {
  name   = "mask_crossings",
  shader = "mask/crossing_motions",
  doc    = "Per cell, the displacements around it by which something behind its pixels may be uncovered",
  fails  = "Of a cell that lies across the border of tiles the candidates of each are tried, up to eight: a pixel too many " ..
           "may be marked.",
  size   = { of = "bounds" },
  reads  = {
    bounds    = { doc = "of the displacements of each cell, px over the exposure" },
    ids       = { uint = true, doc = "least and greatest instance + 1 of each cell" },
    motions_0 = motions, motions_1 = motions, motions_2 = motions, motions_3 = motions,
    reach = reach,
  },
  writes = {
    crossing_0 = pair "first and second displacement, px over the exposure; 1e9 = none",
    crossing_1 = pair "third and fourth",
    crossing_2 = pair "fifth and sixth",
    crossing_3 = pair "seventh and eighth",
  },
  params = {
    cell_side = blur.cell_side,
    tile      = blur.tile,
    limit     = blur.limit,
    match     = path.match,
    margin    = path.margin,
  },
}
