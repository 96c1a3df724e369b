-- SPDX-License-Identifier: MIT
-- A tracking shot: the camera follows a vase, so that the room moves past. A figure of one moment, with errors, and a film.
--   strobe capture scripts/captures/tracking.lua -o out/tracking
local capture = require "strobe.capture"

return capture {
  title = "A tracking shot",
  size = { 480, 270 },
  shots = {
    { name = "moment", scene = "living_room", camera = "tracking" },
    { name = "ride", scene = "living_room", camera = "tracking", ["scene.pixels"] = 8, frames = { 0, 15, 1 } },
  },
  arms = {
    { name = "McGuire 2012", pipeline = "mcguire2012", shots = { "moment" } },
    { name = "UE4-style", pipeline = "ue4", shots = { "moment" } },
    { name = "adaptive", pipeline = "adaptive" },
    { name = "truth", pipeline = "ground_truth", set = { samples = 64, times = "stratified" }, shots = { "moment" } },
  },
  truth = "truth",
  figures = {
    {
      name = "tracking", shot = "moment", letters = true, width_mm = 178, text_size = 22,
      columns = {
        { arm = "McGuire 2012" }, { arm = "UE4-style" }, { arm = "adaptive" }, { arm = "truth", label = "ground truth" },
      },
      rows = {
        { caption = "FLIP {flip %.4f}, inner RMSE {rmse inner %.4f}" },
        { label = "difference from truth", against = "truth", gain = 4 },
      },
      cells = { { row = 1, column = "ground truth", caption = "" }, { row = 2, column = "ground truth", empty = true } },
    },
  },
  films = { { name = "ride", shot = "ride", arm = "adaptive", fps = 12, margin = 0 } },
}
