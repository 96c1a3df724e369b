-- SPDX-License-Identifier: MIT
-- A pane of tinted glass in a frame slides to the right in front of a wall, by `pixels` px over the exposure. `alpha`: opacity
-- of the glass.
local scene = require "strobe.scene"
local studio = require "scripts.scenes.lib.studio"

local pixels, alpha = scene.param("pixels", 40), scene.param("alpha", 0.4)
local view = studio.open({ 0, 1, 3.6 }, { 0, 1, 0 }, 30)
local tint = scene.srgb "#3f8f7a"

local glass = scene.material { name = "glass", color = { tint[1], tint[2], tint[3], alpha }, roughness = 0.4, blend = true }
local frame = studio.plain("frame", "#2b2a28", 0.6)

local wide, tall, bar = 0.9, 0.9, 0.04
local parts = { { shape = scene.quad { size = { wide, tall } }, material = glass } }
for _, side in ipairs { -1, 1 } do
  parts[#parts + 1] = { shape = scene.box { size = { bar, tall + bar, bar } }, material = frame,
    position = { side * wide / 2, 0, 0 } }
  parts[#parts + 1] = { shape = scene.box { size = { wide, bar, bar } }, material = frame,
    position = { 0, side * tall / 2, 0 } }
end

return view:scene("glass", {
  studio.wall { name = "wall", position = { 0, 1, -1.1 }, size = { 4.8, 3 }, cell = 0.16, depth = 0.35, seed = 19 },
  scene.node { name = "pane", position = { 0.1, 1, 0 }, parts = parts,
    motion = { velocity = view:velocity { pixels * view:metres_per_pixel { 0, 1, 0 } } } },
})
