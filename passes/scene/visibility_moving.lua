-- SPDX-License-Identifier: MIT
-- Visible triangle of the moving instances, for pipelines that take static surfaces from the raster time.
local pass = require "strobe.pass"

return pass.raster {
  name   = "visibility_moving",
  shader = "scene/visibility",
  doc    = "Nearest triangle at each sample position; with a static camera, of moving instances alone",
  writes = { hit = { format = "rgba32ui",
    doc = "visible surface: instance + 1 (0 for the sky or a static surface), geometry, primitive, 0" } },
  params = {
    only_moving = pass.bool { true, role = "moving_alone", doc = "skip static instances if the camera is static" },
  },
  fails  = "Includes moving surfaces behind static ones: readers must compare with the depth at the raster time.",
}
