-- SPDX-License-Identifier: MIT
-- Cells in which a gather is certain: all that comes there moves alike, and a few rays agree.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"
local reach = require "passes.lib.reach"

return pass.trace {
  name   = "uniform_motion",
  shader = "tile/uniform_motion",
  doc    = "Whether all that comes to a cell within the exposure moves alike, and a few rays find nothing else",
  fails  = "What is smaller than a cell, and neither seen at the capture nor met by one of the rays, is missed.",
  breaks = { mirrored = "which pixels of a cell have a ray is drawn by the cell's place" },
  size   = { of = "bounds" },
  reads  = {
    bounds   = { doc = "of the displacements of each cell, px over the exposure" },
    velocity = { doc = "px over the exposure, of what the capture sees" },
    id       = { uint = true, doc = "its instance + 1; sky = 0" },
    reach    = reach,
  },
  writes = {
    certain = { format = "r8_unorm", doc = "1 where a gather along the motion is right, 1/2 where nothing moves, else 0" },
    longest = { format = "rg32f", doc = "longest displacement of what comes there, px over the exposure" },
  },
  without = { motion = { certain = 0, longest = 0 } },
  params = {
    cell_side = blur.cell_side,
    limit     = blur.limit,
    apart_px  = pass.float { 0.5, min = 0, max = 1000, unit = "px",
      doc = "by how much displacements that come to a cell may differ" },
    audit_rays = pass.int { 8, min = 0, max = 64, doc = "rays of a cell, each at a place and time of its own" },
  },
  counters = {
    checked = "cells whose motion is even, in which rays looked for anything else",
    refuted = "of those, cells in which one found something else",
  },
}
