-- SPDX-License-Identifier: MIT
-- A card over the whole picture with a checker of 8 x 8 texels, black and white in turn. The picture shows `repeats`
-- copies of the checker across, from `start` on (in repeats), with the lookup's `filter` and `wrap`.
local scene = require "strobe.scene"
local pixels = require "scripts.scenes.lib.pixels"

local picture = pixels.picture(64, 64)
local checker = scene.texture.checker {
  size = { 8, 8 }, count = 8, colors = { { 0, 0, 0 }, { 1, 1, 1 } }, filter = scene.param("filter", "nearest"),
  wrap = scene.param("wrap", "repeat"),
}
local repeats, start = scene.param("repeats", 1), scene.param("start", 0)
local paper = scene.material {
  name = "paper", unlit = true,
  color_texture = scene.use { texture = checker, scale = { repeats, repeats }, offset = { start, start } },
}
return pixels.scene(picture, "sampler", {
  pixels.rectangle(picture, "card", { 0, 0, picture.width, picture.height }, 0, paper),
})
