-- SPDX-License-Identifier: MIT
-- Three layers of leaves. Each leaf is an object that drifts and turns in its own way: front leaves to the right, middle leaves
-- to the left, rear leaves downwards. `pixels`: mean displacement of the leaves over the exposure, px. The displacement of a
-- single leaf differs from this mean by up to a third.
local scene = require "strobe.scene"
local studio = require "scripts.scenes.lib.studio"

local pixels, degrees = scene.param("pixels", 60), scene.param("degrees", 25)
local per_layer = scene.param("per_layer", 7)
local view = studio.open({ 0, 1, 3.6 }, { 0, 1, 0 }, 30)
local random = studio.generator(scene.param("seed", 8))

local greens = {}
for i, colors in ipairs { { "#3d6b35", "#a9c37c" }, { "#7c8f35", "#dcd79a" }, { "#a8561f", "#e8b56c" } } do
  greens[i] = scene.material { name = "leaf " .. i, roughness = 0.6, color_texture = scene.texture.leaf {
    size = { 128, 256 }, colors = { scene.srgb(colors[1]), scene.srgb(colors[2]) } } }
end

local function leaf(name, position, direction, material)
  local size, turn = 0.42 + 0.2 * random(), 360 * random()
  local away = pixels * (2 / 3 + 2 / 3 * random()) * view:metres_per_pixel(position)
  local angle = direction + (random() - 0.5)
  local around = { random() - 0.5, random() - 0.5, 1 }
  return scene.node {
    name = name, position = position, rotation = { 50 * (random() - 0.5), 50 * (random() - 0.5), turn },
    material = material,
    shape = scene.tube {
      path = { { 0, -size / 2, 0 }, { 0, -0.2 * size, 0.03 }, { 0, 0.15 * size, 0.04 }, { 0, size / 2, 0 } },
      radii = { 0.006, 0.2 * size, 0.16 * size, 0.003 }, flatten = 0.06, segments = 12, smooth = 5, up = { 0, 0, 1 },
    },
    motion = {
      velocity = view:velocity { away * math.cos(angle), away * math.sin(angle), 0 },
      axis = around, degrees_per_second = view:rate(degrees * 2 * (random() - 0.5)),
    },
  }
end

local leaves = {}
for layer, direction in ipairs { 0, math.pi, -math.pi / 2 } do
  for i = 1, per_layer do
    local x = ((i - 0.5) / per_layer - 0.5) * 2.7 + 0.25 * (random() - 0.5)
    leaves[#leaves + 1] = leaf(("leaf_%d_%d"):format(layer, i),
      { x, 1 + 0.9 * (random() - 0.5), 0.7 - 0.4 * layer }, direction, greens[1 + (i + layer) % 3])
  end
end

return view:scene("leaves", {
  studio.wall { name = "wall", position = { 0, 1, -1.4 }, size = { 4.8, 3 }, cell = 0.15, depth = 0.35, seed = 13 },
  leaves,
})
