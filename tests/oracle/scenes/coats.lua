-- SPDX-License-Identifier: MIT
-- Cards behind each other fill the picture of a pinhole camera at the origin, at depths 10, 11, 12 and 13. The scene
-- has no light, so radiance is the cards' emission. The second card differs from the first in radiance, the third in
-- the base colour to either side of the axis, the fourth in the mean of its material, too.
local scene = require "strobe.scene"

for _, side in ipairs { "width", "height" } do scene.param(side, 16) end -- given to every scene, but not used here

local extent = 100 -- beyond the picture

local function grey(value) return { value, value, value } end

local function card(index, emitted, left, right)
  local z = -(9 + index)
  return scene.node {
    name = "card" .. index,
    shape = scene.triangles {
      positions = { { -extent, -extent, z }, { extent, -extent, z }, { extent, extent, z }, { -extent, extent, z } },
      uvs = { { 0, 1 }, { 1, 1 }, { 1, 0 }, { 0, 0 } },
      indices = { 1, 2, 3, 1, 3, 4 },
    },
    material = scene.material {
      name = "coat" .. index, emissive = grey(emitted),
      color_texture = scene.texture.texels { width = 2, height = 1, texels = { grey(left), grey(right) } },
    },
  }
end

return scene {
  name = "coats",
  nodes = {
    card(1, 0.5, 0.4, 0.6), card(2, 0.7, 0.4, 0.6), card(3, 0.5, 0.6, 0.4), card(4, 0.5, 0.2, 0.2),
    scene.node { name = "camera", camera = scene.camera { name = "main", fov = 90, near = 0.1 } },
  },
}
