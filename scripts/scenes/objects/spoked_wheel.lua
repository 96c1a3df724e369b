-- SPDX-License-Identifier: MIT
-- A wheel rolls to the right on the ground in front of a wall, without slipping. Tyre, rim, hub and spokes are one object. Over
-- the exposure, the wheel turns by `degrees`, its axle moves by `pixels` px, and its top moves by nearly twice as much.
local scene = require "strobe.scene"
local studio = require "scripts.scenes.lib.studio"

local degrees, pixels = scene.param("degrees", 45), scene.param("pixels", 60)
local spokes = scene.param("spokes", 10)

local radius = 0.5
local path = radius * math.rad(degrees)
local focal_px = scene.param("height", 270) / 2 / math.tan(math.rad(15))
local view = studio.open({ 0.1, 0.85, path / pixels * focal_px }, { -0.05, 0.6, 0 }, 30)

local rubber, rim = studio.plain("rubber", "#2b2a28", 0.9), studio.plain("rim", "#c9a24c", 0.4)
local pale, red = studio.plain("pale", "#e9e4d6", 0.6), studio.plain("red", "#a8321f", 0.6)

local parts = {
  { shape = scene.torus { radius = radius - 0.045, tube_radius = 0.045 }, material = rubber, rotation = { 90, 0, 0 } },
  { shape = scene.torus { radius = radius - 0.1, tube_radius = 0.022 }, material = rim, rotation = { 90, 0, 0 } },
  { shape = scene.cylinder { radius = 0.08, height = 0.16 }, material = rim, rotation = { 90, 0, 0 } },
  { shape = scene.cylinder { radius = 0.05, height = 0.18 }, material = red, rotation = { 90, 0, 0 } },
}
for i = 0, spokes - 1 do
  local angle = 2 * math.pi * i / spokes
  local c, s, slant = math.cos(angle), math.sin(angle), i % 2 == 0 and 0.05 or -0.05
  parts[#parts + 1] = { material = i % 2 == 0 and pale or red, shape = scene.tube {
    path = { { 0.06 * c, 0.06 * s, slant }, { (radius - 0.1) * c, (radius - 0.1) * s, 0 } }, radius = 0.014 } }
end

return view:scene("spoked_wheel", {
  studio.wall { name = "wall", position = { 0, 1, -1.1 }, size = { 5, 3.2 }, cell = 0.16, depth = 0.4, seed = 7 },
  studio.floor { size = { 8, 8 }, cell = 0.18 },
  scene.node {
    name = "wheel", position = { 0.16, radius, 0 }, rotation = { 0, 12, 0 }, parts = parts,
    motion = { velocity = view:velocity { path * math.cos(math.rad(12)), 0, -path * math.sin(math.rad(12)) },
      axis = { math.sin(math.rad(12)), 0, math.cos(math.rad(12)) }, degrees_per_second = -view:rate(degrees) },
  },
})
