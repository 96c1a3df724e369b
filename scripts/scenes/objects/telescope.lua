-- SPDX-License-Identifier: MIT
-- A telescope on a tripod turns by `degrees` over the exposure. The three parts of the telescope (dew cap, barrel,
-- eyepiece) are objects with one parent node. At the raster time, the telescope points `off` degrees beside the camera,
-- so the dew cap hides the barrel. At earlier times the barrel is visible. `pixels`: displacement of the front of the
-- cap over the exposure, px.
local scene = require "strobe.scene"
local studio = require "scripts.scenes.lib.studio"

local degrees, off = scene.param("degrees", 12), scene.param("off", 1.5)
local pixels = scene.param("pixels", 100)

local pivot, front = { 0, 1.2, 0 }, 0.9  -- front: distance of the rim of the cap from the pivot, metres
-- The rim moves sideways by front * 2 sin(degrees / 2). The camera is at the distance where this length spans `pixels` px.
local focal_px = scene.param("height", 270) / 2 / math.tan(math.rad(15))
local distance = front + front * 2 * math.sin(math.rad(degrees / 2)) * focal_px / pixels
local view = studio.open({ 0, pivot[2] + 0.12, distance }, pivot, 30)

local brass, dark = studio.plain("brass", "#c9a24c", 0.45), studio.plain("dark", "#2b2a28", 0.6)
local white, red = studio.plain("white", "#e9e4d6", 0.5), studio.plain("red", "#a8321f", 0.6)

-- Returns one object of closed cylinders along z. Each entry of `list` is a cylinder between the positions `from` and `to`,
-- metres.
local function tubes(name, list)
  local parts = {}
  for i, tube in ipairs(list) do
    parts[i] = { shape = scene.cylinder { radius = tube.radius, height = tube.to - tube.from, segments = 40 },
      material = tube.material, rotation = { 90, 0, 0 }, position = { 0, 0, (tube.from + tube.to) / 2 } }
  end
  return scene.node { name = name, parts = parts }
end

local barrel = {}
for i = 0, 7 do
  local from = -0.6 + i * 0.15
  barrel[#barrel + 1] = { radius = 0.105, from = from, to = from + 0.15, material = i % 2 == 0 and white or red }
end

local legs = {}
for i = 0, 2 do
  local angle = math.rad(30 + 120 * i)
  legs[i + 1] = { material = brass, shape = scene.tube { radius = 0.018, path = {
    { 0, pivot[2] - 0.1, 0 }, { 0.5 * math.cos(angle), 0, 0.5 * math.sin(angle) } } } }
end
legs[4] = { material = dark, shape = scene.cylinder { radius = 0.05, height = 0.12 },
  position = { 0, pivot[2] - 0.14, 0 } }

return view:scene("telescope", {
  studio.wall { name = "wall", position = { 0, 1.2, -1.6 }, size = { 4.8, 3 }, cell = 0.15, depth = 0.35, seed = 4 },
  studio.floor { size = { 6, 6 }, cell = 0.2 },
  scene.node { name = "tripod", parts = legs },
  scene.node {
    name = "telescope", position = pivot, rotation = { -3, off, 0 },
    motion = { axis = { 0, 1, 0 }, degrees_per_second = view:rate(degrees) },
    children = {
      tubes("dew_cap", { { radius = 0.135, from = 0.6, to = 0.86, material = dark },
                         { radius = 0.14, from = 0.86, to = front, material = brass },
                         { radius = 0.115, from = front, to = front + 0.004, material = white },
                         { radius = 0.085, from = front + 0.004, to = front + 0.008, material = red },
                         { radius = 0.05, from = front + 0.008, to = front + 0.012, material = white } }),
      tubes("barrel", barrel),
      tubes("eyepiece", { { radius = 0.05, from = -0.85, to = -0.6, material = brass },
                          { radius = 0.065, from = -0.95, to = -0.85, material = dark } }),
    },
  },
})
