-- SPDX-License-Identifier: MIT
-- A box is thrown away from the camera, past a post: at the start of the exposure before it, at the capture farther away and
-- beside it. By the depths of the capture it went behind the post.
local scene = require "strobe.scene"
local studio = require "scripts.scenes.lib.studio"

local view = studio.open({ 0, 0.9, 6 }, { 0, 0.7, 0 }, 30)

return view:scene("thrown", {
  studio.wall { name = "wall", position = { 0, 1.3, -2.5 }, size = { 12, 3.4 }, cell = 0.25, depth = 0.8, seed = 9 },
  studio.floor { size = { 24, 8 }, cell = 0.4 },
  scene.node {
    name = "post", position = { 0, 0.9, 0.6 }, shape = scene.box { size = { 0.2, 1.8, 0.2 } },
    material = studio.plain("cream", "#efe4c8", 0.6),
  },
  scene.node {
    name = "box", position = { 0.8, 0.8, -1 }, shape = scene.box { size = { 0.4, 0.4, 0.4 } },
    material = studio.plain("red", "#b3261e", 0.6), motion = { velocity = view:velocity { 0.9, 0, -3 } },
  },
})
