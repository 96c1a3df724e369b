-- SPDX-License-Identifier: MIT
-- Cells where a gather is reliable, because all surfaces that reach the cell move alike and a few rays confirm this.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"
local max_displacement = require "passes.lib.max_displacement"

return pass.trace {
  doc    = "Cells where a gather is reliable, because all surfaces that reach the cell move alike and a few rays confirm this",
  fails  = "Misses objects smaller than a cell that are neither in the raster layer nor hit by a validation ray.",
  breaks = {
    mirrored = "the pixels of a cell with validation rays are not mirrored with the picture",
    reversed = "the times of the validation rays are not reversed with the exposure",
  },
  size   = { of = "bounds" },
  reads  = {
    bounds           = { doc = "least and greatest displacement in each cell, component by component, px over the exposure" },
    velocity         = { doc = "screen displacement of each pixel of the raster layer, px over the exposure" },
    id               = { uint = true, doc = "instance index + 1 of the raster layer; 0 for the sky" },
    max_displacement = max_displacement,
  },
  writes = {
    certain = { format = "r8_unorm",
      doc = "1 where a gather along the motion is reliable, 1/2 where nothing moves, 1/4 where a validation ray has " ..
            "refuted one of these two cases, otherwise 0" },
    longest = { format = "rg32f", doc = "longest displacement of the surfaces that reach the cell, px over the exposure" },
  },
  if_no = { motion = { certain = 0, longest = 0 } },
  params = {
    cell_side = blur.cell_side,
    limit     = blur.limit,
    apart_px  = pass.float { 0.5, min = 0, max = 1000, unit = "px",
      doc = "largest difference between the displacements of the surfaces that reach a cell, for their motion to " ..
            "count as uniform" },
    validation_rays = pass.int { 8, min = 0, max = 64,
      doc = "number of validation rays per cell, each at its own pixel and time" },
  },
  counters = {
    checked = "cells with uniform motion, validated by rays",
    mismatched = "cells with uniform motion, rejected because a validation ray hit another point than the motion predicts",
  },
}
