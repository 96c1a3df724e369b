-- SPDX-License-Identifier: MIT
-- A glazed vase with two handles turns about its axis by `degrees` over the exposure, under a lamp. The body of the vase is a
-- body of revolution in one colour, so it looks the same at all times, and the reflection of the lamp on the body is static.
-- Only the handles move in the picture. `pixels`: arc length of the path of a handle over the exposure, px.
local scene = require "strobe.scene"
local studio = require "scripts.scenes.lib.studio"

local degrees, pixels = scene.param("degrees", 40), scene.param("pixels", 40)
local reach = 0.4
local focal_px = scene.param("height", 270) / 2 / math.tan(math.rad(15))
local view = studio.open({ 0, 0.85, reach * math.rad(degrees) / pixels * focal_px }, { 0, 0.55, 0 }, 30)

local glaze = scene.material { name = "glaze", color = scene.srgb "#14707a", roughness = 0.25 }
local parts = { { material = glaze, shape = scene.lathe { segments = 96, smooth = 6, profile = {
  { 0, 0 }, { 0.16, 0 }, { 0.28, 0.25 }, { 0.3, 0.5 }, { 0.16, 0.78 }, { 0.12, 0.9 }, { 0.17, 1 }, { 0, 0.98 } } } } }
for _, side in ipairs { -1, 1 } do
  parts[#parts + 1] = { material = glaze, shape = scene.torus { radius = 0.12, tube_radius = 0.025 },
    position = { side * 0.28, 0.66, 0 }, rotation = { 90, 0, 0 } }
end

return view:scene("gloss", {
  studio.wall { name = "wall", position = { 0, 0.9, -1.3 }, size = { 5, 3 }, cell = 0.16, depth = 0.35, seed = 27 },
  studio.floor { size = { 6, 6 }, cell = 0.2 },
  scene.node { name = "vase", rotation = { 0, 35, 0 }, parts = parts,
    motion = { axis = { 0, 1, 0 }, degrees_per_second = view:rate(degrees) } },
  scene.node { name = "lamp", position = { 1.4, 1.7, 1.6 }, light = scene.point_light { intensity = 8 } },
})
