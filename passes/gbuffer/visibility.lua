-- SPDX-License-Identifier: MIT
-- Visible triangle of each pixel: the raster pass of every pipeline. All other images are derived from this image.
local pass = require "strobe.pass"

return pass.raster {
  doc    = "Nearest triangle at each pixel's sample position, by rasterisation",
  writes = { hit = { format = "rgba32ui", doc = "visible surface, by indices: instance + 1 (0 for the sky), geometry, " ..
      "triangle, 0" } },
}
