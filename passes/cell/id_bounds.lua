-- SPDX-License-Identifier: MIT
-- Least and greatest instance number in each cell.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  doc    = "Least and greatest instance number in each cell",
  fails  = "Does not fail, but can be loose: the interval also contains numbers of instances that are not in the cell.",
  size   = { of = "id", divide = "cell_side" },
  reads  = { id = { uint = true, doc = "instance + 1; 0 for the sky" } },
  writes = { ids = { format = "rg32ui",
    doc = "least and greatest instance + 1; both are equal if the cell shows one instance" } },
  params = { cell_side = blur.cell_side },
}
