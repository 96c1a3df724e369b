-- SPDX-License-Identifier: MIT
-- Lit cards at several depths that move in several directions before a wall, for a pinhole camera: for properties of
-- any picture. At 64x40 the focal length is 64 px: 1 px at depth z is z / 64. No two cards have the same speed.
-- mirror = -1 mirrors left and right; speed multiplies all motion; scale multiplies all lengths, and the light, so the
-- picture stays the same; brightness multiplies only the light; value > 0 is the colour of every surface; crumbs is the
-- number of small static cards.
local scene = require "strobe.scene"

scene.param("width", 64) -- given to every scene, but not used here
local height = scene.param("height", 40)
local mirror, speed, scale = scene.param("mirror", 1), scene.param("speed", 1), scene.param("scale", 1)
local value, brightness = scene.param("value", 0), scene.param("brightness", 1)
local crumbs = scene.param("crumbs", 0)
local exposures_per_second = 24 / 0.5

local function material(name, color)
  if value > 0 then return scene.material { name = name, color = { value, value, value }, unlit = true } end
  return scene.material { name = name, color = color, roughness = 0.5 }
end

-- Centre and size in pixels at its depth, displacement in pixels over the exposure (x right, y down).
local function card(name, depth, centre, size, displacement, color)
  local pixel = depth / 64 * scale
  local rate = pixel * exposures_per_second * speed
  return scene.node {
    name = name, position = { mirror * centre[1] * pixel, -centre[2] * pixel, -depth * scale },
    shape = scene.quad { size = { size[1] * pixel, size[2] * pixel } }, material = material(name, color),
    motion = { velocity = { mirror * displacement[1] * rate, -displacement[2] * rate, 0 } },
  }
end

-- In rows of 20, each card at its own depth.
local function crumb(i)
  local place = { 3.25 * (i % 20) - 30.875, 2.5 * (i // 20) - 18 }
  return card("crumb " .. i, 20 + i / 64, place, { 1.5, 1.25 }, { 0, 0 }, { 0.3, 0.6, 0.2 })
end

local nodes = {
  card("wall", 32, { 2.375, 4.5 }, { 48.5, 40.5 }, { 0, 0 }, { 0.5, 0.4, 0.3 }),
  card("band", 24, { 0, 3.25 }, { 96, 6.5 }, { -6.25, 0 }, { 0.2, 0.7, 0.3 }),
  card("high", 16, { -12.125, -6.75 }, { 14.5, 10.5 }, { 9.125, 3.25 }, { 0.9, 0.2, 0.1 }),
  card("low", 12, { 9.875, 8.25 }, { 11.5, 12.5 }, { 0.75, -7.125 }, { 0.1, 0.2, 0.9 }),
  card("near", 8, { 13.375, -8.5 }, { 6.5, 15.5 }, { -11.25, 1.375 }, { 0.8, 0.8, 0.1 }),
  card("still", 9, { -20.125, 8.25 }, { 8.5, 9.5 }, { 0, 0 }, { 0.6, 0.1, 0.6 }),
  scene.node {
    name = "lamp", position = { mirror * 0.5 * scale, 2 * scale, -2 * scale },
    light = scene.point_light { intensity = 400 * scale * scale * brightness },
  },
  scene.node {
    name = "camera",
    camera = scene.camera { name = "main", fov = math.deg(2 * math.atan(height / 2 / 64)), near = 0.5 * scale },
  },
}
for i = 0, crumbs - 1 do table.insert(nodes, crumb(i)) end

return scene {
  name = "crowd",
  environment = { background = value > 0 and { value, value, value } or { 0.25, 0.5, 1 } },
  nodes = nodes,
}
