-- SPDX-License-Identifier: MIT
-- A pendulum swings by `degrees` over the exposure in the open case of a clock, behind the bars of the case. Rod and bob of the
-- pendulum are one object. `pixels`: arc length of the path of the bob over the exposure, px.
local scene = require "strobe.scene"
local studio = require "scripts.scenes.lib.studio"

local degrees, pixels = scene.param("degrees", 25), scene.param("pixels", 100)

local pivot, length = { 0, 2, 0 }, 1
local focal_px = scene.param("height", 270) / 2 / math.tan(math.rad(15))
local view = studio.open({ 0, 1.3, length * math.rad(degrees) / pixels * focal_px }, { 0, 1.25, 0 }, 30)

local walnut, brass = studio.plain("walnut", "#5c3a21", 0.6), studio.plain("brass", "#c9a24c", 0.4)
local red, cream = studio.plain("red", "#a8321f", 0.6), studio.plain("cream", "#efe4c8", 0.6)

local case = {}
local function bar(size, position) case[#case + 1] = { shape = scene.box { size = size }, material = walnut,
  position = position } end
for _, side in ipairs { -1, 1 } do
  bar({ 0.05, 1.7, 0.5 }, { side * 0.75, 1.2, -0.05 })
  bar({ 0.025, 1.7, 0.025 }, { side * 0.16, 1.2, 0.18 })
end
bar({ 1.5, 0.025, 0.025 }, { 0, 1.33, 0.18 })

return view:scene("pendulum", {
  studio.wall { name = "wall", position = { 0, 1.3, -0.7 }, size = { 3.6, 2.4 }, cell = 0.12, depth = 0.25, seed = 5 },
  scene.node { name = "case", parts = case },
  scene.node {
    name = "pendulum", position = pivot, rotation = { 0, 0, degrees * 0.6 },
    motion = { axis = { 0, 0, 1 }, degrees_per_second = view:rate(degrees) },
    parts = {
      { shape = scene.cylinder { radius = 0.012, height = length }, material = brass, position = { 0, -length / 2, 0 } },
      { shape = scene.cylinder { radius = 0.16, height = 0.06, bevel = 0.02 }, material = brass, rotation = { 90, 0, 0 },
        position = { 0, -length, 0 } },
      { shape = scene.cylinder { radius = 0.11, height = 0.07 }, material = red, rotation = { 90, 0, 0 },
        position = { 0, -length, 0 } },
      { shape = scene.box { size = { 0.13, 0.04, 0.08 } }, material = cream, position = { 0, -length, 0 } },
    },
  },
})
