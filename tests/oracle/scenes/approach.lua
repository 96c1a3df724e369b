-- SPDX-License-Identifier: MIT
-- A striped card 4 m before a pinhole camera that approaches by 1 m over the exposure (24 frames per second, half a
-- frame), before a wall. The displacements of its points change in length, but not in direction.
local scene = require "strobe.scene"
local pixels = require "scripts.scenes.lib.pixels"

return scene {
  name = "approach",
  nodes = {
    scene.node {
      name = "card", position = { 0, 0, -4 }, motion = { velocity = { 0, 0, 48 } }, shape = scene.quad { size = { 3, 3 } },
      material = pixels.textured("card", 12, 1, pixels.stripes(12, 1, 0.9, 0.2)),
    },
    scene.node {
      name = "wall", position = { 0, 0, -9 }, shape = scene.quad { size = { 30, 30 } }, material = pixels.flat("wall", 0.5),
    },
    scene.node { name = "camera", camera = scene.camera { name = "main", fov = 60, near = 0.1 } },
  },
}
