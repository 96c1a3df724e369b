-- SPDX-License-Identifier: MIT
-- Regions for error reports, from ground truth alone.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Pixels whose exposure contains farther, disoccluded or nearer surfaces than the surface at the raster time",
  size   = { of = "regions" },
  reads  = { regions = { uint = true,
    doc = "regions of the time samples as bits, combined by bitwise or: 1 inner, 2 hidden, 4 outer, 8 self" } },
  writes = {
    inner  = { format = "r8_unorm", doc = "1 where any time sample hits another, farther instance than at the raster time" },
    hidden = { format = "r8_unorm", doc = "1 where any time sample hits a point that is occluded at the raster time" },
    outer  = { format = "r8_unorm", doc = "1 where any time sample hits another, nearer instance than at the raster time" },
    self   = { format = "r8_unorm",
      doc = "1 where any time sample hits a point, occluded at the raster time, of the instance visible at the raster time" },
  },
}
