-- SPDX-License-Identifier: MIT
-- Figure 2 of Tan, Cui and Bhojan 2020: the line of samples that a pixel averages. McGuire et al. 2012 put the pixel in the
-- middle of this line, so that half of the exposure is before and half is after the raster time. Tan et al. put the pixel at
-- the end of the line.
--   strobe capture scripts/captures/figure2.lua -o out/figure2
local capture = require "strobe.capture"

local function shot(anchor) return { name = anchor, scene = "living_room", camera = "main", anchor = anchor } end

-- Samples of three pixels: inside the vase, near its edge, and beside the vase.
local ranges = {}
for i, at in ipairs { { 500, 262 }, { 524, 276 }, { 550, 290 } } do
  ranges[i] = { at = at, along = "neighbour_max.dominant", samples = 5, displacement = i == 1 }
end

return capture {
  title = "Range of samples for each pixel",
  size = { 960, 540 },
  layers = { "depth", "velocity", "shade.color", "neighbour_max.dominant" },
  shots = { shot "centre", shot "end", shot "start" },
  arms = { { name = "gather", pipeline = "mcguire2012" } },
  figures = {
    {
      name = "figure2", width_mm = 178, text_size = 15, arm = "gather", crop = { 420, 200, 200, 130 }, zoom = 2,
      columns = {
        { shot = "centre", label = "centre: the pixel in the middle (McGuire et al.)" },
        { shot = "end", label = "end: raster time at the end of the exposure (the paper)" },
        { shot = "start", label = "start: raster time at the start of the exposure" },
      },
      rows = {
        { label = "raster image and samples", view = "shade.color", ranges = ranges },
        { label = "blurred picture" },
      },
    },
  },
}
