-- SPDX-License-Identifier: MIT
-- A card of brightness 0.9 over the whole picture, before a wall of 0.2. Its texture, the only one of the scene, has
-- two texels side by side: alpha is 1 in the left half of the picture and `alpha` in the right half. An alpha below one
-- half is a hole.
local scene = require "strobe.scene"
local pixels = require "scripts.scenes.lib.pixels"

local picture = pixels.picture(32, 8)
local texels = { { 0.9, 0.9, 0.9, 1 }, { 0.9, 0.9, 0.9, scene.param("alpha", 0.25) } }
local paper = scene.material {
  name = "paper", unlit = true, alpha_cutoff = 0.5,
  color_texture = scene.texture.texels { width = 2, height = 1, texels = texels, wrap = "clamp" },
}
return pixels.scene(picture, "cut_out", {
  pixels.rectangle(picture, "wall", { -8, -8, picture.width + 8, picture.height + 8 }, -10, pixels.flat("wall", 0.2)),
  pixels.rectangle(picture, "card", { 0, 0, picture.width, picture.height }, 0, paper),
})
