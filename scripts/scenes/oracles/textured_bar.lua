-- SPDX-License-Identifier: MIT
-- A striped bar over a striped background: the bar moves by `d_f` px, the background by `d_b` px over the exposure. The colour
-- of a pixel is piecewise constant in time, so the exact picture is known (docs/derivations.md). At frame 0, texels coincide
-- with pixels. Texel i of the bar (i from 0) covers the pixel column left + i, and texel i of the background covers the column
-- i - margin. The first stripe of the bar starts at the column `left`, a stripe of the background starts at column 0, and both
-- stripes have the lighter colour.
local scene = require "strobe.scene"
local pixels = require "scripts.scenes.lib.pixels"

local picture = pixels.picture(256, 32)
local left = scene.param("left", 96)
local right = scene.param("right", 160)
local d_f = scene.param("d_f", 20)
local d_b = scene.param("d_b", 0)
local period_f = scene.param("period_f", 8) -- width of a stripe of the bar, px
local period_b = scene.param("period_b", 8)
local f_light, f_dark = scene.param("f_light", 0.9), scene.param("f_dark", 0.6)
local b_light, b_dark = scene.param("b_light", 0.4), scene.param("b_dark", 0.1)

-- Width of the background beyond the left and right border of the picture, px. It exceeds the displacement, and is a multiple
-- of the width of two stripes, so that a light stripe begins at column 0.
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
