-- SPDX-License-Identifier: MIT
-- A lamp moves past static objects, by `metres` to the right over the exposure. Shadows and highlights move, but all visible
-- surfaces are static.
local scene = require "strobe.scene"
local studio = require "scripts.scenes.lib.studio"

local metres = scene.param("metres", 0.6)
local view = studio.open({ 0, 1.3, 4 }, { 0, 0.5, 0 }, 30)

local things = {}
for i, shape in ipairs { scene.cylinder { radius = 0.05, height = 1 }, scene.sphere { radius = 0.28 },
  scene.box { size = { 0.4, 0.5, 0.4 }, radius = 0.03 }, scene.cylinder { radius = 0.05, height = 1.2 } } do
  local height = ({ 0.5, 0.28, 0.25, 0.6 })[i]
  things[i] = scene.node { name = "thing_" .. i, shape = shape, position = { 0.7 * i - 1.75, height, 0.3 * (i % 2) },
    material = studio.plain("thing " .. i, studio.colors[i], 0.3) }
end

return view:scene("lamp", {
  studio.wall { name = "wall", position = { 0, 0.9, -1.2 }, size = { 5.6, 3 }, cell = 0.17, depth = 0.3, seed = 29 },
  studio.floor { size = { 8, 6 }, cell = 0.4, colors = { "#d9d2c0", "#c9c0ab" } },
  things,
  scene.node { name = "lamp", position = { 0, 1.8, 1.6 }, light = scene.point_light { intensity = 5 },
    motion = { velocity = view:velocity { metres } } },
})
