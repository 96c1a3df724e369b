-- SPDX-License-Identifier: MIT
-- Pixel regions for error reports, from the surfaces that the time samples of ground truth hit.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Masks for error reports: pixels that show a farther, nearer or disoccluded surface at some time of the exposure",
  size   = { of = "regions" },
  reads  = { regions = { uint = true,
    doc = "regions for error reports, combined over all time samples by bitwise or, as bits: 1 inner, 2 hidden, 4 outer, 8 " ..
          "self. The outputs with these names define the regions" } },
  writes = {
    inner  = { format = "r8_unorm", doc = "1 where any time sample hits another, farther instance than the instance visible " ..
                                          "at the raster time" },
    hidden = { format = "r8_unorm", doc = "1 where any time sample hits a point that is occluded at the raster time" },
    outer  = { format = "r8_unorm", doc = "1 where any time sample hits another, nearer instance than the instance visible " ..
                                          "at the raster time" },
    self   = { format = "r8_unorm",
      doc = "1 where any time sample hits the instance that is visible at the raster time, at a point that is occluded at " ..
            "that time" },
  },
}
