-- SPDX-License-Identifier: MIT
-- A grey surface covers the columns [left, right) at frame 0 and moves by `d_f` px over the exposure. The static background is
-- white up to the column `border` and black beyond it, so it is white behind the surface (docs/derivations.md, "A background
-- that is invented").
local scene = require "strobe.scene"
local pixels = require "scripts.scenes.lib.pixels"

local picture = pixels.picture(480, 32)
local left, right = scene.param("left", 160), scene.param("right", 288)
local d_f = scene.param("d_f", 40)
local foreground = scene.param("foreground", 0.5)
local border = scene.param("border", 296)

-- The background is one instance, so that the border between white and black is not a silhouette.
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
