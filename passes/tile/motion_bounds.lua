-- SPDX-License-Identifier: MIT
-- Between which displacements all of a cell lie: what a filter must not expect to find there.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  name   = "motion_bounds",
  shader = "tile/motion_bounds",
  doc    = "The least and the greatest displacement of each cell, component by component",
  size   = { of = "velocity", divide = "cell" },
  reads  = {
    velocity       = { doc = "px over the exposure" },
    after_velocity = { optional = true, doc = "px over the exposure, at times after the capture" },
    valid          = { optional = true, doc = "above 1/2 where they count; absent: everywhere" },
  },
  writes = { bounds = { format = "rgba32f",
    doc = "least x and y, greatest x and y, px over the exposure; least above greatest where nothing counts" } },
  params = {
    cell  = blur.cell,
    limit = blur.limit,
  },
}
