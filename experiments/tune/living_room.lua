-- SPDX-License-Identifier: MIT
-- Written by `strobe tune`. Use it with `--set preset=` and the name of this file.
local preset = require "strobe.preset"

return preset {
  doc = "hybrid tuned on living_room, 320x180: least inner RMSE, 0.01362, within half of the time that the passes of hybrid " ..
    "itself (without rasterisation and shading) take with default settings",
  set = {
    composite = "in_gather",
    depth_extent = 0.005,
    max_layers = 16,
    tile = 20,
  },
}
