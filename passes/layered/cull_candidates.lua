-- SPDX-License-Identifier: MIT
-- Candidate displacements of the background, culled per cell; third step of the disocclusion mask.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"
local path = require "passes.lib.relative_path"
local max_displacement = require "passes.lib.max_displacement"

local function pair(doc) return { format = "rgba32f", doc = doc } end

local velocities = { doc = "two candidate displacements per tile, px over the exposure; 1e9 for none" }

return pass.compute {
  doc    = "Candidate background displacements per cell that may disocclude a surface there",
  fails  = "A cell that overlaps several tiles keeps the candidates of each tile, up to eight in all. Extra pixels may " ..
           "then be marked, and further candidates are lost.",
  size   = { of = "bounds" },
  reads  = {
    bounds       = { doc = "bounds of the displacements in each cell, px over the exposure" },
    ids          = { uint = true, doc = "least and greatest instance + 1 in each cell; 0 for the sky" },
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
