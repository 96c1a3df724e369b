-- SPDX-License-Identifier: MIT
-- A card slides in front of a wall with small cards on it. Experiments with this scene measure the time of a frame; each
-- parameter varies one quantity that may influence this time. Lengths are shares of the picture's height, so that the picture
-- looks the same at every size. Parameters:
-- cover      side of the moving card, as a share of the height
-- shift      displacement of this card over the exposure, as a share of the height
-- instances  number of small cards on the wall; a square number of cards covers a quarter of the picture
-- cells      number of squares along a side of the wall; each square has two triangles
-- lights     number of point lights, all with shadows; their total intensity does not depend on the number
local scene = require "strobe.scene"

local cover, shift = scene.param("cover", 0.4), scene.param("shift", 0.09)
local instances, cells, lights = scene.param("instances", 16), scene.param("cells", 16), scene.param("lights", 1)

-- At z = 0, where the moving card is, the picture is 1 unit high. The wall is farther away and larger than the picture.
local distance, behind, per_second = 2, 0.6, 24 / 0.5
local fov = math.deg(2 * math.atan(0.5 / distance))
local wall = (distance + behind) / distance
local columns = math.ceil(math.sqrt(instances))

local function painted(name, first, second, count)
  return scene.material {
    name = name, roughness = 0.8,
    color_texture = scene.texture.checker { colors = { scene.srgb(first), scene.srgb(second) }, count = count },
  }
end

local nodes = {
  scene.node { name = "wall", position = { 0, 0, -behind }, material = painted("wall", "#d8d0c0", "#50606c", 24),
    shape = scene.quad { size = { 2.2 * wall, 1.2 * wall }, segments = cells } },
  scene.node { name = "card", position = { 0, 0, 0 }, material = painted("card", "#c04830", "#f0d890", 6),
    shape = scene.quad { size = { cover, cover } }, motion = { velocity = { shift * per_second, 0, 0 } } },
  scene.node { name = "camera", position = { 0, 0, distance },
    camera = scene.camera { name = "main", fov = fov, near = 0.05 } },
}

local small = scene.quad { size = { 0.9 * wall / columns, 0.5 * wall / columns } }
local green = painted("small", "#2c6e50", "#a8c8a0", 4)
for i = 0, instances - 1 do
  local column, row = i % columns, i // columns
  nodes[#nodes + 1] = scene.node {
    name = "small_" .. i, shape = small, material = green,
    position = { 1.8 * wall * ((column + 0.5) / columns - 0.5), wall * ((row + 0.5) / columns - 0.5), 0.05 - behind },
  }
end

for i = 1, lights do
  local angle = 2 * math.pi * i / lights
  nodes[#nodes + 1] = scene.node {
    name = "light_" .. i, position = { 0.8 * math.cos(angle), 0.8 * math.sin(angle), 1 },
    light = scene.point_light { intensity = 6 / lights },
  }
end

return scene {
  name = "cards", nodes = nodes, environment = { sky = { 0.3, 0.3, 0.3 }, ground = { 0.2, 0.2, 0.2 } },
  shot = { width = 320, height = 180, fps = 24, frame = 0, exposure = 0.5 },
}
