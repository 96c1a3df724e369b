-- SPDX-License-Identifier: MIT
-- A racing car from behind. The camera and the car move ahead by `metres` over the exposure. So the car is static in the
-- picture, while the road with its marks moves towards the camera.
local scene = require "strobe.scene"
local studio = require "scripts.scenes.lib.studio"

local metres = scene.param("metres", 1.2)
local view = studio.open({ 0, 0.95, 3.2 }, { 0, 0.42, 0 }, 34)
local ahead = { velocity = view:velocity { 0, 0, -metres } }

local red, dark = studio.plain("paint", "#b3261e", 0.35), studio.plain("dark", "#22262b", 0.5)
local cream, chrome = studio.plain("cream", "#efe4c8", 0.6), studio.plain("chrome", "#cfd4d8", 0.3)

local car = {
  { shape = scene.box { size = { 1, 0.34, 1.9 }, radius = 0.08 }, material = red, position = { 0, 0.32, 0 } },
  { shape = scene.box { size = { 0.8, 0.28, 0.9 }, radius = 0.1 }, material = dark, position = { 0, 0.58, -0.1 } },
  { shape = scene.box { size = { 1.1, 0.05, 0.22 } }, material = cream, position = { 0, 0.72, 0.82 } },
  { shape = scene.box { size = { 0.5, 0.1, 0.03 } }, material = cream, position = { 0, 0.36, 0.95 } },
}
for _, side in ipairs { -1, 1 } do
  car[#car + 1] = { shape = scene.box { size = { 0.05, 0.26, 0.1 } }, material = dark, position = { side * 0.4, 0.58, 0.82 } }
  for _, z in ipairs { -0.6, 0.6 } do
    car[#car + 1] = { shape = scene.cylinder { radius = 0.22, height = 0.2, bevel = 0.03 }, material = dark,
      rotation = { 0, 0, 90 }, position = { side * 0.52, 0.22, z } }
    car[#car + 1] = { shape = scene.cylinder { radius = 0.12, height = 0.21 }, material = chrome, rotation = { 0, 0, 90 },
      position = { side * 0.52, 0.22, z } }
  end
end

local marks = {}
for i = 0, 29 do
  for k, x in ipairs { -0.7, 0, 0.7 } do
    marks[#marks + 1] = { shape = scene.box { size = { 0.1, 0.01, 0.45 } }, material = cream,
      position = { x, 0.005, 4 - 0.9 * i - 0.3 * k } }
  end
  for _, x in ipairs { -2.2, 2.2 } do
    marks[#marks + 1] = { shape = scene.box { size = { 0.08, 0.7, 0.08 } }, material = i % 2 == 0 and red or cream,
      position = { x, 0.35, 3 - 0.9 * i } }
  end
end

return view:scene("chase", {
  studio.wall { name = "wall", position = { 0, 2, -16 }, size = { 20, 5 }, cell = 0.5, depth = 0.8, seed = 9 },
  studio.floor { name = "road", size = { 30, 60 }, cell = 0.35, colors = { "#6d6a66", "#57544f" } },
  scene.node { name = "marks", parts = marks },
  scene.node { name = "car", parts = car, motion = ahead },
}, ahead)
