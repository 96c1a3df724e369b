-- SPDX-License-Identifier: MIT
-- Written by `strobe tune`. Use it with `--set preset=` and the name of this file.
local preset = require "strobe.preset"

return preset {
  doc = "adaptive tuned on living_room, 320x180: least inner RMSE, 0.01668, within half of the time that the passes of " ..
    "adaptive itself (without rasterisation and shading) take with default settings",
  set = {
    quality = 0.283,
    samples = 8,
    tile = 27,
  },
}
