-- SPDX-License-Identifier: MIT
-- A half-plane of constant colour moves over a background of constant colour. At frame 0, the half-plane covers x < `edge` px;
-- its edge moves by `d_f` px over the exposure. docs/derivations.md has a formula of the exact blurred picture.
local scene = require "strobe.scene"
local pixels = require "scripts.scenes.lib.pixels"

local picture = pixels.picture(160, 32)
local edge = scene.param("edge", 80)
local d_f = scene.param("d_f", 20)
local foreground = scene.param("foreground", 1)
local background = scene.param("background", 0)

local beyond = 2 * math.abs(d_f) + picture.width -- keeps all edges but one outside of the picture
return pixels.scene(picture, "half_plane", {
  pixels.rectangle(picture, "background", { -beyond, -8, picture.width + beyond, picture.height + 8 }, -10,
    pixels.flat("background", background)),
  pixels.rectangle(picture, "foreground", { -beyond, -8, edge, picture.height + 8 }, 0,
    pixels.flat("foreground", foreground), pixels.motion(picture, d_f)),
})
