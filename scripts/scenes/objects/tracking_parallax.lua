-- SPDX-License-Identifier: MIT
-- The camera moves to the right past static objects at many depths: posts, balls, boxes, a wall. `pixels`: displacement
-- over the exposure of objects at the middle depth, px. In the picture, the nearest post moves more than twice as far,
-- and the wall half as far.
local scene = require "strobe.scene"
local studio = require "scripts.scenes.lib.studio"

local pixels = scene.param("pixels", 50)
local view = studio.open({ 0, 1.1, 4 }, { 0, 0.85, 0 }, 32)
local path = pixels * view:metres_per_pixel { 0, 0.8, 0 }
local random = studio.generator(scene.param("seed", 3))

local things = {}
local function put(name, shape, position, color)
  things[#things + 1] = scene.node { name = name, shape = shape, position = position, rotation = { 0, 40 * random(), 0 },
    material = studio.plain(name, color) }
end
for i = 0, 12 do
  local depth = 2.2 - 0.34 * i
  local x = (i * 0.618 % 1 - 0.5) * 0.9 * view:depth { 0, 0.8, depth } * view.width / view.focal_px
  local color = studio.colors[1 + i % #studio.colors]
  if i % 3 == 0 then
    put("post_" .. i, scene.cylinder { radius = 0.035, height = 2.6, segments = 24 }, { x, 1.3, depth }, color)
  elseif i % 3 == 1 then
    put("ball_" .. i, scene.sphere { radius = 0.2 }, { x, 0.2 + 0.9 * random(), depth }, color)
  else
    put("box_" .. i, scene.box { size = { 0.3, 0.6, 0.3 }, radius = 0.02 }, { x, 0.3, depth }, color)
  end
end

return view:scene("tracking_parallax", {
  studio.wall { name = "wall", position = { 0, 1.2, -3.6 }, size = { 9, 4 }, cell = 0.25, depth = 0.7, seed = 17 },
  studio.floor { size = { 12, 12 }, cell = 0.25 },
  things,
}, { velocity = view:velocity { path } })
