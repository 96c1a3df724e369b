-- SPDX-License-Identifier: MIT
-- A comb of one instance with teeth 10 px wide every 20 px. It moves by `d_f` pixels over the exposure before static
-- stripes: displaced by 20 px, each tooth lies on the next one.
local scene = require "strobe.scene"
local pixels = require "scripts.scenes.lib.pixels"

local picture = pixels.picture(128, 16)
local d_f = scene.param("d_f", 20)

local positions = {}
for tooth = -4, picture.width // 20 + 4 do
  local left, right = tooth * 20 + 4 - picture.width / 2, tooth * 20 + 14 - picture.width / 2
  local top, bottom = picture.height / 2 + 8, -picture.height / 2 - 8
  for _, corner in ipairs { { left, top }, { left, bottom }, { right, bottom },
                            { left, top }, { right, bottom }, { right, top } } do
    positions[#positions + 1] = { corner[1], corner[2], 0 }
  end
end

local stripes = pixels.textured("stripes", picture.width + 80, 1, pixels.stripes(picture.width + 80, 4, 0.9, 0.1))
return pixels.scene(picture, "comb", {
  pixels.rectangle(picture, "stripes", { -40, -8, picture.width + 40, picture.height + 8 }, -10, stripes),
  scene.node {
    name = "comb", shape = scene.triangles { positions = positions }, material = pixels.flat("comb", 0.5),
    motion = pixels.motion(picture, d_f),
  },
})
