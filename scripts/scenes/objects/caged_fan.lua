-- SPDX-License-Identifier: MIT
-- A fan in a thin static cage, in front of a wall. Blades and hub are one object, which turns by `degrees` over the exposure.
-- The wires of the cage are in front of the blades and behind them. `pixels`: arc length of the path of a blade's tip over the
-- exposure, px.
local scene = require "strobe.scene"
local studio = require "scripts.scenes.lib.studio"

local degrees, pixels = scene.param("degrees", 60), scene.param("pixels", 80)
local blades = scene.param("blades", 4)

local hub, reach = { 0, 1.1, 0 }, 0.46
local focal_px = scene.param("height", 270) / 2 / math.tan(math.rad(15))
local view = studio.open({ 0.35, 1.3, reach * math.rad(degrees) / pixels * focal_px }, { 0, 1, 0 }, 30)

local steel, dark = studio.plain("steel", "#c3c7ca", 0.35), studio.plain("dark", "#2b2a28", 0.6)
local paints = { studio.plain("red", "#a8321f", 0.6), studio.plain("cream", "#efe4c8", 0.6) }

local wheel = { { shape = scene.cylinder { radius = 0.09, height = 0.14, bevel = 0.02 }, material = dark,
  rotation = { 90, 0, 0 } } }
for i = 0, blades - 1 do
  local angle, pitch = 2 * math.pi * i / blades, math.rad(28)
  local c, s = math.cos(angle), math.sin(angle)
  local function at(r) return { r * c, r * s, 0 } end
  wheel[#wheel + 1] = { material = paints[1 + i % 2], shape = scene.tube {
    path = { at(0.06), at(0.18), at(0.34), at(reach) }, radii = { 0.03, 0.11, 0.14, 0.05 }, flatten = 0.08,
    segments = 16, smooth = 5, up = { -s * math.sin(pitch), c * math.sin(pitch), math.cos(pitch) } } }
end

local cage = {}
for _, ring in ipairs { { 0.5, 0 }, { 0.48, 0.12 }, { 0.48, -0.12 }, { 0.3, 0.17 }, { 0.3, -0.17 }, { 0.12, 0.19 } } do
  cage[#cage + 1] = { material = steel, position = { 0, 0, ring[2] }, rotation = { 90, 0, 0 },
    shape = scene.torus { radius = ring[1], tube_radius = 0.006, tube_segments = 6 } }
end
for i = 0, 17 do
  local angle = 2 * math.pi * i / 18
  local c, s = math.cos(angle), math.sin(angle)
  for _, side in ipairs { 1, -1 } do
    cage[#cage + 1] = { material = steel, shape = scene.tube { radius = 0.004, segments = 6, path = {
      { 0.1 * c, 0.1 * s, side * 0.19 }, { 0.3 * c, 0.3 * s, side * 0.17 }, { 0.48 * c, 0.48 * s, side * 0.12 },
      { 0.5 * c, 0.5 * s, 0 } } } }
  end
end

return view:scene("caged_fan", {
  studio.wall { name = "wall", position = { 0, 1.1, -1.3 }, size = { 4.8, 3 }, cell = 0.15, depth = 0.35, seed = 21 },
  studio.floor { size = { 6, 6 }, cell = 0.2 },
  scene.node { name = "stand", parts = {
    { shape = scene.cylinder { radius = 0.03, height = hub[2] - 0.05 }, material = dark,
      position = { 0, hub[2] / 2, -0.24 } },
    { shape = scene.cylinder { radius = 0.24, height = 0.05, bevel = 0.015 }, material = dark,
      position = { 0, 0.025, -0.24 } },
    { shape = scene.cylinder { radius = 0.1, height = 0.2, bevel = 0.03 }, material = paints[1], rotation = { 90, 0, 0 },
      position = { 0, hub[2], -0.3 } },
  } },
  scene.node { name = "cage", position = hub, parts = cage },
  scene.node { name = "blades", position = hub, rotation = { 0, 0, 17 }, parts = wheel,
    motion = { axis = { 0, 0, 1 }, degrees_per_second = -view:rate(degrees) } },
})
