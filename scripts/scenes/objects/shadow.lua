-- SPDX-License-Identifier: MIT
-- A ball flies to the right over a pale floor in low sun, by `pixels` px over the exposure; its shadow moves with it. A static
-- mast casts a static shadow.
local scene = require "strobe.scene"
local studio = require "scripts.scenes.lib.studio"

local pixels = scene.param("pixels", 50)
local view = studio.open({ 0, 1.5, 4.2 }, { 0.15, 0.45, 0 }, 30)

return view:scene("shadow", {
  studio.wall { name = "wall", position = { 0, 1.2, -2.2 }, size = { 7, 3 }, cell = 0.2, depth = 0.3, seed = 23 },
  studio.floor { size = { 9, 8 }, cell = 0.5, colors = { "#d9d2c0", "#c9c0ab" } },
  scene.node { name = "mast", position = { 1.1, 0.6, -0.7 }, shape = scene.cylinder { radius = 0.05, height = 1.2 },
    material = studio.plain("mast", "#7c2d2a") },
  scene.node { name = "ball", position = { -0.25, 0.75, 0 }, shape = scene.sphere { radius = 0.26, segments = 48 },
    material = studio.plain("red", "#b3261e", 0.5),
    motion = { velocity = view:velocity { pixels * view:metres_per_pixel { 0, 0.6, 0 } } } },
})
