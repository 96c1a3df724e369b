-- SPDX-License-Identifier: MIT
-- Written by `strobe tune`; taken by `--set preset=` and the name of this file.
local preset = require "strobe.preset"

return preset {
  doc = "hybrid tuned on living_room, 320x180: 0.01572, " ..
    "the least rmse (inner) within 0.5 times the own cost of hybrid as it is",
  set = {
    composite = "alpha_over",
    depth_extent = 0.005,
    limit = 0.05,
    tile = 20,
  },
}
