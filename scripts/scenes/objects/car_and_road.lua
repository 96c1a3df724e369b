-- SPDX-License-Identifier: MIT
-- A car with rolling wheels drives to the right on a road with posts. Seen by a static camera, the car would move by `pixels`
-- px over the exposure. The camera moves along with the car, by the share `follow` of the car's path. At 0 the road is static
-- in the picture, at 1 the car is static.
local scene = require "strobe.scene"
local studio = require "scripts.scenes.lib.studio"

local pixels, follow = scene.param("pixels", 100), scene.param("follow", 0.9)
local view = studio.open({ -0.3, 1.3, 6.2 }, { 0, 0.7, 0 }, 30)

local path = pixels * view:metres_per_pixel { 0, 0.6, 0.5 }
local wheel_radius = 0.24

local red, dark = studio.plain("paint", "#b3261e", 0.35), studio.plain("dark", "#22262b", 0.5)
local rubber, chrome = studio.plain("rubber", "#1d1c1b", 0.9), studio.plain("chrome", "#cfd4d8", 0.3)
local cream = studio.plain("cream", "#efe4c8", 0.6)

local body = {
  { shape = scene.box { size = { 2.3, 0.36, 0.95 }, radius = 0.08 }, material = red, position = { 0, 0.46, 0 } },
  { shape = scene.box { size = { 1.2, 0.36, 0.85 }, radius = 0.12 }, material = dark, position = { -0.15, 0.78, 0 } },
  { shape = scene.box { size = { 0.05, 0.3, 0.87 } }, material = red, position = { -0.15, 0.78, 0 } },
  { shape = scene.box { size = { 2.1, 0.05, 0.97 } }, material = cream, position = { 0, 0.42, 0 } },
  { shape = scene.box { size = { 0.06, 0.09, 0.98 } }, material = chrome, position = { 1.15, 0.36, 0 } },
  { shape = scene.box { size = { 0.06, 0.09, 0.98 } }, material = chrome, position = { -1.15, 0.36, 0 } },
}

local function wheel(name, x, z)
  local parts = {
    { shape = scene.cylinder { radius = wheel_radius, height = 0.16, bevel = 0.03 }, material = rubber,
      rotation = { 90, 0, 0 } },
    { shape = scene.cylinder { radius = 0.15, height = 0.165 }, material = chrome, rotation = { 90, 0, 0 } },
  }
  for i = 0, 2 do
    parts[#parts + 1] = { shape = scene.box { size = { 0.26, 0.04, 0.175 } }, material = dark, rotation = { 0, 0, 60 * i } }
  end
  return scene.node { name = name, position = { x, wheel_radius, z }, parts = parts,
    motion = { axis = { 0, 0, 1 }, degrees_per_second = -view:rate(math.deg(path / wheel_radius)) } }
end

local posts = {}
for i = 0, 23 do
  local x = (i - 11.5) * 0.6
  posts[#posts + 1] = { shape = scene.box { size = { 0.07, 0.8, 0.07 } }, material = cream, position = { x, 0.4, -0.9 } }
  posts[#posts + 1] = { shape = scene.box { size = { 0.075, 0.16, 0.075 } }, material = red, position = { x, 0.62, -0.9 } }
end
posts[#posts + 1] = { shape = scene.box { size = { 14, 0.08, 0.03 } }, material = chrome, position = { 0, 0.5, -0.87 } }
local marks = {}
for i = 0, 15 do
  marks[#marks + 1] = { shape = scene.box { size = { 0.5, 0.01, 0.1 } }, material = cream,
    position = { (i - 7.5) * 0.9, 0.005, 1.1 } }
end

return view:scene("car_and_road", {
  studio.wall { name = "wall", position = { 0, 1.3, -2.5 }, size = { 12, 3.4 }, cell = 0.25, depth = 0.8, seed = 9 },
  studio.floor { name = "road", size = { 24, 8 }, cell = 0.4, colors = { "#6d6a66", "#57544f" } },
  scene.node { name = "posts", parts = posts },
  scene.node { name = "marks", parts = marks },
  scene.node {
    name = "car", position = { 0.1, 0, 0.4 }, motion = { velocity = view:velocity { path } },
    children = {
      scene.node { name = "body", parts = body },
      wheel("wheel_front", 0.72, 0.4), wheel("wheel_back", -0.72, 0.4),
      wheel("wheel_front_far", 0.72, -0.4), wheel("wheel_back_far", -0.72, -0.4),
    },
  },
}, { velocity = view:velocity { follow * path } })
