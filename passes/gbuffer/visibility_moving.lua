-- SPDX-License-Identifier: MIT
-- Visible triangle of the moving instances, for pipelines that draw static surfaces only once, at the raster time.
local pass = require "strobe.pass"

return pass.raster {
  shader = "gbuffer/visibility",
  doc    = "Nearest triangle at each pixel's sample position, by rasterisation; with a static camera, only moving instances " ..
           "are drawn",
  writes = { hit = { format = "rgba32ui",
    doc = "visible surface, by indices: instance + 1 (0 for the sky or a static surface), geometry, triangle, 0" } },
  runs   = "moving_instances",
  fails  = "With a static camera, the image includes moving surfaces behind static ones. Passes that read `hit` must " ..
           "therefore compare the depth of the hit with the depth of the static surface at the raster time.",
}
