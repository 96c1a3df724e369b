-- SPDX-License-Identifier: MIT
-- A striped bar over a striped background; both move. The colour of a pixel is piecewise constant in time
-- (docs/derivations.md). At frame 0, texel i of the bar covers exactly the pixel column left + i, and texel i of the background
-- the column i - margin. The stripes of the bar start at `left`, the stripes of the background at column 0, both with the
-- lighter colour.
local scene = require "strobe.scene"
local pixels = require "scripts.scenes.lib.pixels"

local picture = pixels.picture(256, 32)
local left = scene.param("left", 96)
local right = scene.param("right", 160)
local d_f = scene.param("d_f", 20)
local d_b = scene.param("d_b", 0)
local period_f = scene.param("period_f", 8) -- width of one stripe, pixels
local period_b = scene.param("period_b", 8)
local f_light, f_dark = scene.param("f_light", 0.9), scene.param("f_dark", 0.6)
local b_light, b_dark = scene.param("b_light", 0.4), scene.param("b_dark", 0.1)

-- The margin is wider than the largest displacement. It is a whole number of stripe pairs wide, so that a pair begins at column
-- 0.
local pair = 2 * period_b
local margin = math.ceil((2 * math.abs(d_b) + 16) / pair) * pair
local columns = picture.width + 2 * margin
return pixels.scene(picture, "textured_bar", {
  pixels.rectangle(picture, "background", { -margin, -8, picture.width + margin, picture.height + 8 }, -10,
    pixels.textured("background", columns, 1, pixels.stripes(columns, period_b, b_light, b_dark)),
    pixels.motion(picture, d_b)),
  pixels.rectangle(picture, "bar", { left, -8, right, picture.height + 8 }, 0,
    pixels.textured("bar", right - left, 1, pixels.stripes(right - left, period_f, f_light, f_dark)),
    pixels.motion(picture, d_f)),
})
