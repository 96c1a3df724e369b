-- SPDX-License-Identifier: MIT
-- A blade turns about column 12 by 60 degrees over the exposure. To its right a striped card at the columns 96 to 128
-- moves by `d_x`, `d_y` px without rotation. Both are before static stripes.
local scene = require "strobe.scene"
local pixels = require "scripts.scenes.lib.pixels"

local picture = pixels.picture(160, 32)
local blade = pixels.rectangle(picture, "blade", { 4, 14, 20, 18 }, 0, pixels.flat("blade", 0.7))
blade.motion = { axis = { 0, 0, 1 }, degrees_per_second = 60 * picture.fps / picture.exposure }

local function striped(name, columns, light, dark)
  return pixels.textured(name, columns, 1, pixels.stripes(columns, 3, light, dark))
end

return pixels.scene(picture, "beside", {
  pixels.rectangle(picture, "stripes", { -8, -8, picture.width + 8, picture.height + 8 }, -10,
    striped("stripes", picture.width + 16, 0.4, 0.1)),
  pixels.rectangle(picture, "card", { 96, 4, 128, 28 }, 0, striped("card", 32, 0.9, 0.6),
    pixels.motion(picture, scene.param("d_x", 14), scene.param("d_y", 5))),
  blade,
})
