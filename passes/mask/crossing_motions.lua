-- SPDX-License-Identifier: MIT
-- Candidate displacements of the background, culled per cell; third step of the disocclusion mask.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"
local path = require "passes.lib.relative_path"
local reach = require "passes.lib.reach"

local function pair(doc) return { format = "rgba32f", doc = doc } end

local motions = { doc = "two candidate displacements per tile, px over the exposure; 1e9 for none" }

return pass.compute {
  name   = "mask_crossings",
  shader = "mask/crossing_motions",
  doc    = "Candidate background displacements per cell that may disocclude a surface there",
  fails  = "Conservative: a cell across a tile border tries the candidates of each tile, up to eight, and may mark extra " ..
           "pixels.",
  size   = { of = "bounds" },
  reads  = {
    bounds    = { doc = "bounds of the displacements in each cell, px over the exposure" },
    ids       = { uint = true, doc = "least and greatest instance + 1 in each cell; 0 for the sky" },
    motions_0 = motions, motions_1 = motions, motions_2 = motions, motions_3 = motions,
    reach = reach,
  },
  writes = {
    crossing_0 = pair "first and second candidate displacement, px over the exposure; 1e9 for none",
    crossing_1 = pair "third and fourth candidate displacement, px over the exposure; 1e9 for none",
    crossing_2 = pair "fifth and sixth candidate displacement, px over the exposure; 1e9 for none",
    crossing_3 = pair "seventh and eighth candidate displacement, px over the exposure; 1e9 for none",
  },
  params = {
    cell_side = blur.cell_side,
    tile      = blur.tile,
    limit     = blur.limit,
    match     = path.match,
    margin    = path.margin,
  },
}
