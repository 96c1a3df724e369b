-- SPDX-License-Identifier: MIT
-- A rectangle moves by (`d_x`, `d_y`) px over the exposure, over a checker with cells of `cell` px. The cell in the top left
-- corner of the picture has the value `b_light`. The exact picture is known: the rectangle covers the centre of a pixel while
-- four inequalities, linear in time, hold (docs/derivations.md).
local scene = require "strobe.scene"
local pixels = require "scripts.scenes.lib.pixels"

local picture = pixels.picture(128, 128)
local left, right = scene.param("left", 40), scene.param("right", 80)
local top, bottom = scene.param("top", 48), scene.param("bottom", 88)
local d_x, d_y = scene.param("d_x", 20), scene.param("d_y", -12)
local cell = scene.param("cell", 8)
local foreground = scene.param("foreground", 0.9)
local b_light, b_dark = scene.param("b_light", 0.5), scene.param("b_dark", 0.1)

-- The texture has four texels and repeats every 2 x 2 cells.
local light, dark = { b_light, b_light, b_light }, { b_dark, b_dark, b_dark }
local checker = scene.material {
  name = "background", unlit = true,
  color_texture = scene.use {
    texture = scene.texture.texels { width = 2, height = 2, texels = { light, dark, dark, light } },
    scale = { picture.width / (2 * cell), picture.height / (2 * cell) },
  },
}
return pixels.scene(picture, "quad_2d", {
  pixels.rectangle(picture, "background", { 0, 0, picture.width, picture.height }, -10, checker),
  pixels.rectangle(picture, "quad", { left, top, right, bottom }, 0,
    pixels.flat("quad", foreground), pixels.motion(picture, d_x, d_y)),
})
