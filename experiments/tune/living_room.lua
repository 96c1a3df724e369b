-- SPDX-License-Identifier: MIT
-- Written by `strobe tune`; taken by `--set preset=` and the name of this file.
local preset = require "strobe.preset"

return preset {
  doc = "hybrid tuned on living_room, 320x180: 0.01362, " ..
    "the least rmse (inner) within 0.5 times the own cost of hybrid as it is",
  set = {
    composite = "in_gather",
    depth_extent = 0.005,
    max_layers = 16,
    tile = 20,
  },
}
