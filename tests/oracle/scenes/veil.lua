-- SPDX-License-Identifier: MIT
-- A card of brightness 0.9 over the whole picture, blended by `alpha`, before a wall of 0.2. It moves by `shift` px
-- over the exposure, and extends beyond the picture by `shift` px on either side.
local scene = require "strobe.scene"
local pixels = require "scripts.scenes.lib.pixels"

local picture = pixels.picture(64, 64)
local shift = scene.param("shift", 0)
local veil = scene.material {
  name = "veil", color = { 0.9, 0.9, 0.9, scene.param("alpha", 0.25) }, unlit = true, blend = true,
}
return pixels.scene(picture, "veil", {
  pixels.rectangle(picture, "wall", { -8, -8, picture.width + 8, picture.height + 8 }, -10, pixels.flat("wall", 0.2)),
  pixels.rectangle(picture, "card", { -shift, 0, picture.width + shift, picture.height }, 0, veil,
    pixels.motion(picture, shift)),
})
