-- SPDX-License-Identifier: MIT
-- A film of a camera that moves around the table of the living room. Only the motion of the camera causes blur.
--   strobe capture scripts/captures/turntable.lua -o out/turntable
local capture = require "strobe.capture"

return capture {
  title = "Around the living room",
  size = { 480, 270 },
  shots = {
    { name = "turn", scene = "living_room", ["scene.pixels"] = 0, frames = { 0, 47, 1 },
      path = capture.orbit { target = { 0.1, 0.7, -0.35 }, radius = 1.6, height = 0.75, first = 0, last = 48 } },
  },
  arms = { { name = "adaptive", pipeline = "adaptive" } },
  films = { { name = "turntable", fps = 24, margin = 0, columns = { { label = "" } } } },
}
