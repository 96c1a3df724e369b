-- SPDX-License-Identifier: MIT
-- Two rectangles and a camera that move, each with its own cut, and a cut of the whole scene, for 96 x 64 px.
-- Displacements `a_x`, `b_y`, `camera_x` are px over the exposure; cuts are in exposures from frame 0, 99 for none.
local scene = require "strobe.scene"
local pixels = require "scripts.scenes.lib.pixels"

local picture = pixels.picture(96, 64)

local function cuts(name)
  local at = scene.param(name .. "_cut", 99)
  return at < 99 and { at * picture.exposure / picture.fps } or nil
end

local function moving(name, edges, z, value, dx, dy)
  local node = pixels.rectangle(picture, name, edges, z, pixels.flat(name, value), pixels.motion(picture, dx, dy))
  node.cuts = cuts(name)
  return node
end

local motes = pixels.textured("background", 288, 1, pixels.stripes(288, 6, 0.5, 0.1))

return scene {
  name = "jumps",
  nodes = {
    pixels.rectangle(picture, "background", { -96, -64, 192, 128 }, -20, motes),
    moving("a", { 30, 8, 58, 28 }, 0, 1, scene.param("a_x", 16), 0),
    moving("b", { 20, 34, 70, 54 }, -5, 0.8, 0, scene.param("b_y", 8)),
    scene.node {
      name = "camera", position = { 0, 0, 100 }, motion = pixels.motion(picture, scene.param("camera_x", 8)),
      cuts = cuts "camera",
      camera = scene.orthographic_camera { name = "main", half_height = picture.height / 2, near = 1 },
    },
  },
  cuts = cuts "scene",
  shot = { width = picture.width, height = picture.height, fps = picture.fps, frame = 0, exposure = picture.exposure },
}
