-- SPDX-License-Identifier: MIT
-- Candidate displacements of hidden background, culled per cell; third step of the disocclusion mask.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"
local path = require "passes.lib.relative_path"
local max_displacement = require "passes.lib.max_displacement"

local function pair(doc) return { format = "rgba32f", doc = doc } end

local velocities = { doc = "two candidate displacements of hidden background per tile, px over the exposure; 1e9 for none" }

return pass.compute {
  doc    = "Candidate displacements of hidden background per cell. A cell takes the candidates of the tiles that it " ..
           "overlaps, and drops the candidates with which no background can be disoccluded in the cell",
  fails  = "A cell that overlaps several tiles tests the candidates of all these tiles, up to eight in all. The " ..
           "disocclusion mask may then have extra pixels, and candidates beyond the eighth are lost.",
  size   = { of = "bounds" },
  reads  = {
    bounds       = { doc = "least and greatest displacement in each cell, component by component, px over the exposure" },
    ids          = { uint = true, doc = "least and greatest instance index + 1 in each cell; 0 for the sky" },
    candidates_0 = velocities, candidates_1 = velocities, candidates_2 = velocities, candidates_3 = velocities,
    max_displacement = max_displacement,
  },
  writes = {
    culled_0 = pair "first and second candidate displacement, px over the exposure; 1e9 for none",
    culled_1 = pair "third and fourth candidate displacement, px over the exposure; 1e9 for none",
    culled_2 = pair "fifth and sixth candidate displacement, px over the exposure; 1e9 for none",
    culled_3 = pair "seventh and eighth candidate displacement, px over the exposure; 1e9 for none",
  },
  params = {
    cell_side = blur.cell_side,
    tile      = blur.tile,
    limit     = blur.limit,
    match     = path.match,
    margin    = path.margin,
  },
}
