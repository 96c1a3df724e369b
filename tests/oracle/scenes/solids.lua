-- SPDX-License-Identifier: MIT
-- A floor up to the horizon, a box on the floor with an edge towards the camera, a ball before a wall of another
-- instance, and sky.
local scene = require "strobe.scene"

scene.param("width", 96)
scene.param("height", 64)

local function solid(name, value, fields)
  fields.name, fields.material = name, scene.material { name = name, color = { value, value, value }, roughness = 0.8 }
  return scene.node(fields)
end

return scene {
  name = "solids",
  environment = { background = { 0.3, 0.4, 0.5 } },
  nodes = {
    solid("floor", 0.4, { shape = scene.quad { size = { 400, 400 } }, rotation = { -90, 0, 0 } }),
    solid("wall", 0.6, { shape = scene.quad { size = { 6, 3 } }, position = { 3, 1.5, -9 } }),
    solid("box", 0.5, { shape = scene.box { size = { 1, 1, 1 } }, position = { -1.2, 0.5, -4 },
      rotation = { 0, 35, 0 } }),
    solid("ball", 0.7, { shape = scene.sphere { radius = 0.6 }, position = { 1.1, 1.2, -5 } }),
    scene.node { name = "camera", position = { 0, 1, 0 },
      camera = scene.camera { name = "main", fov = 60, near = 0.1 } },
  },
}
