-- SPDX-License-Identifier: MIT
-- Written by `strobe tune`. Use it with `--set preset=` and the name of this file.
local preset = require "strobe.preset"

return preset {
  doc = "adaptive tuned on living_room, 320x180: rmse 0.01562. " ..
    "Goal: the least rmse (inner) within 0.5 times the own cost of adaptive as it is",
  set = {
    depth_extent = 0.00878,
    jitter_frame = "per_frame",
    limit = 1.81,
    quality = 0.351,
    samples = 7,
    tile = 14,
    tile_rule = "all",
  },
}
