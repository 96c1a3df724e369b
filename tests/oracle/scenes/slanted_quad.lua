-- SPDX-License-Identifier: MIT
-- A quad with sides oblique to the axes moves by (11.5, -6.25) pixels over a checker of 8 pixels (.4, .1) that moves by
-- (-3.5, 2.25).
local scene = require "strobe.scene"
local pixels = require "scripts.scenes.lib.pixels"

local picture = pixels.picture(72, 56)
local corners = { { 20.3, 12.1 }, { 50.2, 16.8 }, { 45.9, 40.4 }, { 17.6, 33.3 } }
local positions = {}
for i, corner in ipairs(corners) do
  positions[i] = { corner[1] - picture.width / 2, picture.height / 2 - corner[2], 0 }
end

local margin = 16 -- two cells: the corner of the checker is a light cell again
local light, dark = { 0.4, 0.4, 0.4 }, { 0.1, 0.1, 0.1 }
local checker = scene.material {
  name = "checker", unlit = true,
  color_texture = scene.use {
    texture = scene.texture.texels { width = 2, height = 2, texels = { light, dark, dark, light } },
    scale = { (picture.width + 2 * margin) / 16, (picture.height + 2 * margin) / 16 },
  },
}

return pixels.scene(picture, "slanted_quad", {
  pixels.rectangle(picture, "checker", { -margin, -margin, picture.width + margin, picture.height + margin }, -10,
    checker, pixels.motion(picture, -3.5, 2.25)),
  scene.node {
    name = "quad", shape = scene.triangles { positions = positions, indices = { 1, 4, 3, 1, 3, 2 } },
    material = pixels.flat("quad", 0.8), motion = pixels.motion(picture, 11.5, -6.25),
  },
})
