-- SPDX-License-Identifier: MIT
-- Least and greatest instance index in each cell.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  doc    = "Least and greatest index of the instances in each cell, so that later passes can test if a cell shows a single " ..
           "instance",
  fails  = "Never too narrow, but may be too wide: the interval may contain indices of instances that are not in the cell.",
  size   = { of = "id", divide = "cell_side" },
  reads  = { id = { uint = true, doc = "instance index + 1; 0 for the sky" } },
  writes = { ids = { format = "rg32ui",
    doc = "least and greatest instance index + 1; both are equal if the cell shows one instance" } },
  params = { cell_side = blur.cell_side },
}
