-- SPDX-License-Identifier: MIT
-- A box approaches the camera, in front of a wall and over a floor. If the exposure ends at the raster time, the distance of
-- the box halves over the exposure. The box then becomes twice as large in the picture, and its points move faster and faster.
-- At most times, the depth of the box differs from its depth at the raster time.
local scene = require "strobe.scene"
local studio = require "scripts.scenes.lib.studio"

local view = studio.open({ 0, 0.9, 6 }, { 0, 0.7, 0 }, 30)
local distance = 3.4

return view:scene("nearer", {
  studio.wall { name = "wall", position = { 0, 1.3, -2.5 }, size = { 12, 3.4 }, cell = 0.25, depth = 0.8, seed = 9 },
  studio.floor { size = { 24, 8 }, cell = 0.4 },
  scene.node {
    name = "box", position = { 0.25, 0.6, 6 - distance }, shape = scene.box { size = { 0.5, 0.5, 0.5 } },
    material = studio.plain("red", "#b3261e", 0.6), motion = { velocity = view:velocity { 0, 0, distance } },
  },
})
