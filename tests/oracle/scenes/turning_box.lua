-- SPDX-License-Identifier: MIT
-- A box of `side` pixels with its vertical axis at pixel column `at`. In plan view its sides lie at `yaw` degrees
-- (anticlockwise) at frame 0. It turns by `degrees` and slides by `d_f` pixels over the exposure, before a wall. A post
-- in front of the box covers the columns from `left` to `right`.
local scene = require "strobe.scene"
local pixels = require "scripts.scenes.lib.pixels"

local picture = pixels.picture(96, 4)
local side, at = scene.param("side", 30), scene.param("at", 48)
local yaw, degrees, d_f = scene.param("yaw", 20), scene.param("degrees", 0), scene.param("d_f", 0)
local left, right = scene.param("left", 0), scene.param("right", 0)

local motion = pixels.motion(picture, d_f)
motion.axis, motion.degrees_per_second = { 0, 1, 0 }, degrees * picture.fps / picture.exposure

local nodes = {
  pixels.rectangle(picture, "wall", { -200, -8, 300, 12 }, -40, pixels.flat("wall", 0.1)),
  scene.node { name = "box", position = { at - picture.width / 2, 0, 0 }, rotation = { 0, yaw, 0 }, motion = motion,
    shape = scene.box { size = { side, 100, side } }, material = pixels.flat("box", 0.8) },
}
if right > left then
  nodes[#nodes + 1] = pixels.rectangle(picture, "post", { left, -8, right, 12 }, 50, pixels.flat("post", 0.4))
end
return pixels.scene(picture, "turning_box", nodes)
