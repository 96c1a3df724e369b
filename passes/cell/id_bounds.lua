-- SPDX-License-Identifier: MIT
-- Interval of instances of each cell.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  doc    = "Least and greatest instance of each cell",
  fails  = "Never. The interval does not list the instances between its ends.",
  size   = { of = "id", divide = "cell_side" },
  reads  = { id = { uint = true, doc = "instance + 1; 0 for the sky" } },
  writes = { ids = { format = "rg32ui", doc = "least and greatest instance + 1; equal if the cell shows one instance" } },
  params = { cell_side = blur.cell_side },
}
