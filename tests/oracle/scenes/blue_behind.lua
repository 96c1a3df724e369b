-- SPDX-License-Identifier: MIT
-- A grey bar [left, right) that moves right by `d_f` px over the exposure, before a wall with equal red and green and
-- with blue larger by `bluer`. Top and bottom of the bar lie outside the picture.
local scene = require "strobe.scene"
local pixels = require "scripts.scenes.lib.pixels"

local picture = pixels.picture(64, 36)
local d_f = scene.param("d_f", 16)
local grey = 0.5
local beyond = 2 * math.abs(d_f) + picture.width
local blue = scene.material { name = "wall", color = { grey, grey, grey + scene.param("bluer", 0.25) }, unlit = true }
return pixels.scene(picture, "blue_behind", {
  pixels.rectangle(picture, "wall", { -beyond, -8, picture.width + beyond, picture.height + 8 }, -10, blue),
  pixels.rectangle(picture, "bar", { scene.param("left", 20), -8, scene.param("right", 42), picture.height + 8 }, 0,
    pixels.flat("bar", grey), pixels.motion(picture, d_f)),
})
