-- SPDX-License-Identifier: MIT
-- Closed objects with one-sided materials under a lamp: a ball that flies, a mirrored ring that turns, a box.
local scene = require "strobe.scene"

local clay = scene.material { name = "clay", color = { 0.7, 0.5, 0.3 }, roughness = 0.6, double_sided = false }
local slate = scene.material { name = "slate", color = { 0.2, 0.3, 0.4 }, roughness = 0.4, double_sided = false }

return scene {
  name = "closed",
  nodes = {
    scene.node { name = "floor", shape = scene.box { size = { 8, 0.2, 8 } }, material = slate, position = { 0, -0.1, 0 } },
    scene.node { name = "ball", shape = scene.sphere {}, material = clay, position = { -0.8, 0.6, 0.4 },
      motion = { velocity = { 9, 0, 0 } } },
    scene.node { name = "ring", shape = scene.torus {}, material = slate, position = { 1, 0.8, -0.5 }, scale = { 1, -1, 1 },
      motion = { axis = { 1, 0, 0 }, degrees_per_second = 700 } },
    scene.node { name = "box", shape = scene.box { size = { 0.8, 0.8, 0.8 }, radius = 0.1 }, material = clay,
      position = { 0, 0.5, -1.2 } },
    scene.node { name = "lamp", position = { 2, 4, 3 }, light = scene.point_light { intensity = 40 } },
    scene.node { name = "eye", position = { 0, 1.5, 4 }, look_at = { 0, 0.4, 0 }, camera = scene.camera { fov = 45 } },
  },
  environment = { sky = { 0.3, 0.3, 0.4 }, ground = { 0.1, 0.1, 0.1 } },
  shot = { width = scene.param("width", 64), height = scene.param("height", 40), frame = 0, exposure = 0.5 },
}
