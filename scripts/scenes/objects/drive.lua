-- SPDX-License-Identifier: MIT
-- The camera moves ahead by `metres` over the exposure, through an avenue of posts and over the marks of a road. The
-- camera passes near objects within the exposure, so these objects are behind the camera at the end of the exposure.
local scene = require "strobe.scene"
local studio = require "scripts.scenes.lib.studio"

local metres = scene.param("metres", 0.5)
local view = studio.open({ 0, 0.8, 4 }, { 0, 0.65, 0 }, 50)

local red, cream = studio.plain("red", "#a8321f"), studio.plain("cream", "#efe4c8")
local posts, marks = {}, {}
for i = 0, 15 do
  local z = 3.6 - 0.8 * i
  for _, x in ipairs { -0.75, 0.75 } do
    posts[#posts + 1] = { shape = scene.box { size = { 0.1, 1.8, 0.1 } }, material = i % 2 == 0 and red or cream,
      position = { x, 0.9, z } }
  end
  marks[#marks + 1] = { shape = scene.box { size = { 0.12, 0.01, 0.4 } }, material = cream, position = { 0, 0.005, z } }
end

return view:scene("drive", {
  studio.wall { name = "wall", position = { 0, 2, -9 }, size = { 14, 5 }, cell = 0.4, depth = 0.6, seed = 15 },
  studio.floor { name = "road", size = { 20, 30 }, cell = 0.4, colors = { "#6d6a66", "#57544f" } },
  scene.node { name = "posts", parts = posts },
  scene.node { name = "marks", parts = marks },
}, { velocity = view:velocity { 0, 0, -metres } })
