-- SPDX-License-Identifier: MIT
-- The output of each pass of the pipeline hybrid_layered, for the vase in front of the cushion.
--   strobe capture scripts/captures/hybrid_passes.lua -o out/hybrid_passes
local capture = require "strobe.capture"

-- Outputs in the order of their passes, three per row. Each entry has an image, a caption and, for displacements, the upper end
-- of the colour scale in px.
local passes = {
  { "visibility.hit", "visibility: instances" },
  { "depth", "gbuffer: depth" },
  { "normal", "gbuffer: normals" },
  { "velocity", "gbuffer: displacement over the exposure", 25 },
  { "shade.color", "shade: colour at the raster time" },
  { "tile_velocities.velocities", "tile_velocities: displacements of a tile", 25 },
  { "mask", "mask: pixels that trace a ray" },
  { "revealed", "reveal: colour of the background" },
  { "revealed_depth", "reveal: depth of the background" },
  { "tile_max.longest", "tile_max: longest displacement", 25 },
  { "neighbour_max.dominant", "neighbour_max: dominant displacement", 25 },
  { "color", "composite: the picture" },
}

local cells, rows = {}, {}
for i, pass in ipairs(passes) do
  local row, column = (i - 1) // 3 + 1, (i - 1) % 3 + 1
  rows[row] = {}
  cells[i] = { row = row, column = column, view = pass[1], caption = pass[2], high = pass[3] }
end

return capture {
  title = "The hybrid, pass by pass",
  size = { 480, 270 },
  shots = { { name = "vase", scene = "living_room", camera = "main" } },
  arms = { { name = "hybrid_layered", pipeline = "hybrid_layered", set = { tile = 20 } } },
  figures = {
    { name = "hybrid_passes", letters = true, width_mm = 178, text_size = 18, rows = rows,
      columns = { { label = "" }, { label = "" }, { label = "" } }, cells = cells },
  },
}
