-- SPDX-License-Identifier: MIT
-- A film that shows longer and longer exposures of one moment, from 1/12 of a frame to a whole frame. The pipeline
-- adaptive is beside ground truth. The vase has the same speed in all pictures.
--   strobe capture scripts/captures/exposure.lua -o out/exposure
local capture = require "strobe.capture"

local exposures = {}
for i = 1, 12 do exposures[i] = i / 12 end

return capture {
  title = "The vase and the cushion at longer and longer exposures",
  size = { 480, 270 },
  shots = {
    { name = "vase", scene = "living_room", camera = "main", ["scene.exposure"] = 0.5, vary = { exposure = exposures } },
  },
  arms = {
    { name = "adaptive", pipeline = "adaptive" },
    { name = "truth", pipeline = "ground_truth", set = { samples = 32 } },
  },
  truth = "truth",
  films = {
    {
      name = "exposure", fps = 4, caption = "exposure {exposure %.3f} of a frame, FLIP {flip %.4f}",
      columns = { { arm = "adaptive" }, { arm = "truth", label = "ground truth", caption = "" } },
    },
  },
}
