-- SPDX-License-Identifier: MIT
-- A door opens into a room. It turns about its hinge by `degrees` over the exposure, and is `open` degrees open at the raster
-- time. The free edge of the door moves by `pixels` px along an arc, and the width of the door in the picture changes.
local scene = require "strobe.scene"
local studio = require "scripts.scenes.lib.studio"

local degrees, open = scene.param("degrees", 32), scene.param("open", 55)
local pixels = scene.param("pixels", 100)

local wide, tall = 0.9, 2
local focal_px = scene.param("height", 270) / 2 / math.tan(math.rad(15))
local view = studio.open({ 0.25, 1.45, wide * math.rad(degrees) / pixels * focal_px }, { 0, 1.35, -0.3 }, 30)

local plaster = scene.material { name = "plaster", roughness = 0.9, color_texture = scene.texture.noise {
  colors = { scene.srgb "#b9a98c", scene.srgb "#d3c5a8" }, count = 24, amount = 1, seed = 5 } }
local paint, panel = studio.plain("door", "#3d6f73", 0.5), studio.plain("panel", "#e0d5bd", 0.5)
local brass, frame = studio.plain("brass", "#c9a24c", 0.35), studio.plain("frame", "#efe8d8", 0.6)

local front = {}
local function slab(size, position, material)
  front[#front + 1] = { shape = scene.box { size = size }, material = material or plaster, position = position }
end
for _, side in ipairs { -1, 1 } do
  slab({ 1.5, 3, 0.12 }, { side * (wide / 2 + 0.05 + 0.75), 1.5, -0.06 })
  slab({ 0.05, tall + 0.05, 0.16 }, { side * (wide / 2 + 0.025), (tall + 0.05) / 2, -0.06 }, frame)
end
slab({ wide, 0.95, 0.12 }, { 0, tall + 0.05 + 0.475, -0.06 })
slab({ wide + 0.1, 0.05, 0.16 }, { 0, tall + 0.025, -0.06 }, frame)

-- The leaf of the door extends to the right from the hinge. The origin of the door's node is at the hinge.
local leaf = { { shape = scene.box { size = { wide, tall, 0.04 } }, material = paint, position = { wide / 2, tall / 2, 0 } } }
for i = 0, 2 do
  for k = 0, 1 do
    leaf[#leaf + 1] = { shape = scene.box { size = { 0.28, 0.46, 0.05 } }, material = panel,
      position = { 0.24 + 0.42 * k, 0.4 + 0.6 * i, 0 } }
  end
end
leaf[#leaf + 1] = { shape = scene.sphere { radius = 0.035 }, material = brass, position = { wide - 0.05, 1, 0.06 } }

return view:scene("door", {
  studio.wall { name = "wall", position = { 0, 1.5, -2.4 }, size = { 4.5, 3 }, cell = 0.15, depth = 0.5, seed = 31 },
  studio.floor { size = { 6, 8 }, cell = 0.2 },
  scene.node { name = "front", parts = front },
  scene.node { name = "table", position = { 0.15, 0, -1.3 }, parts = {
    { shape = scene.box { size = { 0.9, 0.04, 0.5 } }, material = brass, position = { 0, 0.75, 0 } },
    { shape = scene.cylinder { radius = 0.04, height = 0.75 }, material = frame, position = { 0, 0.375, 0 } },
    { shape = scene.sphere { radius = 0.14 }, material = panel, position = { 0.1, 0.91, 0 } },
  } },
  scene.node { name = "door", position = { -wide / 2, 0, -0.06 }, rotation = { 0, open, 0 }, parts = leaf,
    motion = { axis = { 0, 1, 0 }, degrees_per_second = view:rate(degrees) } },
})
