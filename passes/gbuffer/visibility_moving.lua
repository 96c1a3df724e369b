-- SPDX-License-Identifier: MIT
-- Visible triangle of the moving instances, for pipelines that take static surfaces from the raster time.
local pass = require "strobe.pass"

return pass.raster {
  shader = "gbuffer/visibility",
  doc    = "Nearest triangle at each sample position; with a static camera, only moving instances are drawn",
  writes = { hit = { format = "rgba32ui",
    doc = "visible surface: instance + 1 (0 for the sky or a static surface), geometry, primitive, 0" } },
  runs   = "moving_instances",
  fails  = "Includes moving surfaces behind static ones. Passes that read `hit` must compare the depth of the hit with " ..
           "the depth at the raster time.",
}
