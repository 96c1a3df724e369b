-- SPDX-License-Identifier: MIT
-- Cells where every surface moves and a gather is not reliable. There, the pipeline `poses` averages raster images of several
-- times.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Cells where every surface moves and a gather is not reliable; there, raster images of several times are averaged",
  size   = { of = "certain" },
  reads  = {
    bounds  = { doc = "least and greatest displacement in each cell, component by component, px over the exposure" },
    certain = { doc = "output `certain` of the pass coherent_cells" },
    longest = { doc = "longest displacement of the surfaces that reach the cell, px over the exposure" },
  },
  writes = {
    drawn     = { format = "rg16f", doc = "x: 1 where images rasterised at several times are averaged, otherwise 0; y: 1" },
    untraced  = { format = "r8_unorm",
      doc = "1 where a gather is reliable, 1/2 where nothing moves or images are averaged, 0 where rays are traced" },
    first_ray = { format = "rg32f", doc = "displacement that the times of the first rays depend on, px over the exposure" },
  },
}
