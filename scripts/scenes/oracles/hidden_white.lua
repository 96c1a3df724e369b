-- SPDX-License-Identifier: MIT
-- A grey surface moves by `d_f` px over the exposure. At frame 0, it covers the pixel columns [left, right). The static
-- background is white up to the column `border` and black beyond this column. So the background is white behind the
-- whole surface at frame 0, although black is visible close to the right edge of the surface. docs/derivations.md has
-- the exact picture, in the section "A background that is invented".
local scene = require "strobe.scene"
local pixels = require "scripts.scenes.lib.pixels"

local picture = pixels.picture(480, 32)
local left, right = scene.param("left", 160), scene.param("right", 288)
local d_f = scene.param("d_f", 40)
local foreground = scene.param("foreground", 0.5)
local border = scene.param("border", 296)

-- White and black are texels of one object, so that the border between white and black is not a silhouette.
local margin = 2 * math.abs(d_f)
local columns = picture.width + 2 * margin
local texels = {}
for i = 1, columns do
  local value = i <= border + margin and 1 or 0
  texels[i] = { value, value, value }
end

return pixels.scene(picture, "hidden_white", {
  pixels.rectangle(picture, "background", { -margin, -8, picture.width + margin, picture.height + 8 }, -10,
    pixels.textured("background", columns, 1, texels)),
  pixels.rectangle(picture, "surface", { left, -8, right, picture.height + 8 }, 0,
    pixels.flat("surface", foreground), pixels.motion(picture, d_f)),
})
