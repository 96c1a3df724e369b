-- SPDX-License-Identifier: MIT
-- Written by `strobe tune`. Use it with `--set preset=` and the name of this file.
local preset = require "strobe.preset"

return preset {
  doc = "hybrid tuned on living_room, 320x180: the least inner RMSE, 0.01362, " ..
    "at up to 0.5 times the own cost of unchanged hybrid",
  set = {
    composite = "in_gather",
    depth_extent = 0.005,
    max_layers = 16,
    tile = 20,
  },
}
