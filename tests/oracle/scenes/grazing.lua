-- SPDX-License-Identifier: MIT
-- A plane at a grazing angle to a parallel camera. `facing` is the cosine of the angle to its normal, which points
-- `turned` degrees up from the right in the picture. Its texture has black and white stripes of 4 texels each. On a
-- plane that recedes as 1:16 the next pixel to the right would lie `deep` texels farther along a stripe, and the pixel
-- below would lie a texel across.
local scene = require "strobe.scene"
local pixels = require "scripts.scenes.lib.pixels"

local picture = pixels.picture(32, 32)
local facing, turned = scene.param("facing", 0.06), math.rad(scene.param("turned", 22.5))
local deep, texels, recedes = scene.param("deep", 8), 8, 16
local c, s, sideways = math.cos(turned), math.sin(turned), math.sqrt(1 - facing * facing)

-- Point of the plane, `aside` m across the receding direction and `away` m along it.
local function point(aside, away)
  return { away * facing * c - aside * s, away * facing * s + aside * c, -away * sideways }
end

-- Texture coordinates by pixels to the right and down: a step to the right is (-s, recedes * c), a step down (-c,
-- -recedes * s).
local function uv(aside, away)
  local right = (-recedes * s * aside + c * away) / recedes
  local down = (-recedes * c * aside - s * away) / recedes
  return { down / texels, deep * right / texels }
end

local positions, uvs = {}, {}
local beside, beyond = picture.width, picture.width / facing
for _, corner in ipairs { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } } do
  positions[#positions + 1] = point(corner[1] * beside, corner[2] * beyond)
  uvs[#uvs + 1] = uv(corner[1] * beside, corner[2] * beyond)
end

local striped = scene.material {
  name = "striped", unlit = true, double_sided = true,
  color_texture = scene.texture.stripes { size = { texels, texels }, count = 1, colors = { { 0, 0, 0 }, { 1, 1, 1 } } },
}
return pixels.scene(picture, "grazing", {
  scene.node {
    name = "plane", position = { 0, 0, -beyond }, material = striped,
    shape = scene.triangles { positions = positions, uvs = uvs, indices = { 1, 2, 3, 1, 3, 4 } },
  },
})
