-- SPDX-License-Identifier: MIT
-- Test scene for motion that turns back at the raster time. A striped card slides over a static checker. The raster time is the
-- time of frame 1. The card moves to the right by `before` px in the half exposure before this frame's time, and by `after` px
-- (negative: back to the left) in the half exposure after this time. The camera is orthographic; one unit is one pixel.
local scene = require "strobe.scene"
local pixels = require "scripts.scenes.lib.pixels"

local picture = pixels.picture(320, 180)
local before, after = scene.param("before", 16), scene.param("after", -16)
local w, h = picture.width, picture.height
local left, right, top, bottom = 0.4 * w // 1, 0.6 * w // 1, 0.3 * h // 1, 0.7 * h // 1

local checker = scene.material {
  name = "background", unlit = true,
  color_texture = scene.use {
    texture = scene.texture.texels { width = 2, height = 2,
      texels = { { 0.5, 0.55, 0.3 }, { 0.05, 0.1, 0.3 }, { 0.05, 0.1, 0.3 }, { 0.5, 0.55, 0.3 } } },
    scale = { w / 16, h / 16 },
  },
}
local card = pixels.rectangle(picture, "card", { left, top, right, bottom }, 0,
  pixels.textured("card", right - left, 1, pixels.stripes(right - left, 8, 0.9, 0.6)))

-- Centre of the card at frame 1, which is the position of its node.
local x, y = (left + right - w) / 2, (h - top - bottom) / 2
local frame = 1 / picture.fps
local function path(displacement) return displacement / (picture.exposure / 2) end
local slide = scene.animation {
  name = "slide",
  tracks = { scene.track { node = "card", times = { 0, frame, 2 * frame },
    values = { { x - path(before), y, 0 }, { x, y, 0 }, { x + path(after), y, 0 } } } },
}

return pixels.scene(picture, "turns_back", {
  pixels.rectangle(picture, "background", { 0, 0, w, h }, -10, checker), card,
}, 0, { slide })
