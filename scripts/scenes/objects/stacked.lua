-- SPDX-License-Identifier: MIT
-- `count` (2 to 4) boxes one behind the other, in front of a wall, each with its own motion. `equal`: true if all boxes have
-- one plain colour, so that only their motions differ. `pixels`: displacement of the first box over the exposure, px; the other
-- boxes move by 0.8 to 1.1 times as much.
local scene = require "strobe.scene"
local studio = require "scripts.scenes.lib.studio"

local count = math.max(2, math.min(4, scene.param("count", 3)))
local equal, pixels = scene.param("equal", false), scene.param("pixels", 80)
local view = studio.open({ 0.1, 1.1, 3.8 }, { 0, 1, 0 }, 30)

local colors = { { "#b5573a", "#f3ead6" }, { "#27405e", "#c9a25a" }, { "#2f5d50", "#e8c9c1" }, { "#41304f", "#9fd0c6" } }
-- Displacement of each box to the right and up, as shares of `pixels`.
local ways = { { 1, 0 }, { -0.9, 0.3 }, { 0.2, -0.8 }, { 0.7, 0.8 } }
local places = { { -0.12, 0.93 }, { 0.16, 1.02 }, { 0, 1.2 }, { 0.08, 0.8 } }

local boxes = {}
for i = 1, count do
  local position = { places[i][1], places[i][2], 0.9 - 0.5 * i }
  local metres = pixels * view:metres_per_pixel(position)
  local size = 0.5 + 0.16 * i
  boxes[i] = scene.node {
    name = "box_" .. i, position = position, rotation = { 0, 12 * i - 20, 7 * i - 10 },
    shape = scene.box { size = { size, 0.8 * size, 0.12 }, radius = 0.02 },
    material = equal and studio.plain("equal", "#b8b0a0") or scene.material {
      name = "box " .. i, roughness = 0.7, color_texture = scene.texture.checker {
        colors = { scene.srgb(colors[i][1]), scene.srgb(colors[i][2]) }, count = 3 + i } },
    motion = { velocity = view:velocity { ways[i][1] * metres, ways[i][2] * metres, 0 } },
  }
end

return view:scene("stacked", {
  studio.wall { name = "wall", position = { 0, 1, -1.9 }, size = { 6.6, 3.6 }, cell = 0.15, depth = 0.3, seed = 23 },
  boxes,
})
