-- SPDX-License-Identifier: MIT
-- A bar of constant colour moves by `d_f` px over the exposure, over a background of constant colour. At frame 0, the bar
-- covers the pixel columns [left, right). The upper and lower ends of the bar lie outside of the picture. docs/derivations.md
-- has a formula of the exact blurred picture.
local scene = require "strobe.scene"
local pixels = require "scripts.scenes.lib.pixels"

local picture = pixels.picture(256, 32)
local left = scene.param("left", 96)
local right = scene.param("right", 160)
local d_f = scene.param("d_f", 20)
local foreground = scene.param("foreground", 1)
local background = scene.param("background", 0)

local beyond = 2 * math.abs(d_f) + picture.width
return pixels.scene(picture, "bar", {
  pixels.rectangle(picture, "background", { -beyond, -8, picture.width + beyond, picture.height + 8 }, -10,
    pixels.flat("background", background)),
  pixels.rectangle(picture, "bar", { left, -8, right, picture.height + 8 }, 0,
    pixels.flat("bar", foreground), pixels.motion(picture, d_f)),
})
