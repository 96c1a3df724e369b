-- SPDX-License-Identifier: MIT
-- Whether a cell shows one instance alone.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  name   = "id_bounds",
  shader = "tile/id_bounds",
  doc    = "The least and the greatest instance of each cell",
  fails  = "Never. Of a cell of several instances it tells no more than that.",
  size   = { of = "id", divide = "cell_side" },
  reads  = { id = { uint = true, doc = "instance + 1; sky = 0" } },
  writes = { ids = { format = "rg32ui", doc = "least and greatest; equal where the cell shows one instance" } },
  params = { cell_side = blur.cell_side },
}
