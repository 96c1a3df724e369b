-- SPDX-License-Identifier: MIT
-- A pinhole camera at the origin that looks along -z, with a focal length of 1000 px: 1 px at depth z is z / 1000. From
-- front to back, in pixels: [20, 60) at depth 10 moves by 15 over the exposure, x < 50 at depth 20 moves by -6, and the
-- static background.
local scene = require "strobe.scene"

local width, height = scene.param("width", 96), scene.param("height", 4)
local exposures_per_second = 24 / 0.5

local function surface(name, left, right, depth, value, displacement)
  local pixel = depth / 1000
  return scene.node {
    name = name,
    position = { ((left + right) / 2 - width / 2) * pixel, 0, -depth },
    shape = scene.quad { size = { (right - left) * pixel, 4 * height * pixel } },
    material = scene.material { name = name, color = { value, value, value }, unlit = true },
    motion = { velocity = { displacement * pixel * exposures_per_second, 0, 0 } },
  }
end

return scene {
  name = "pinhole",
  environment = { background = { 0.1, 0.1, 0.1 } },
  nodes = {
    surface("front", 20, 60, 10, 0.8, 15),
    surface("back", -200, 50, 20, 0.3, -6),
    scene.node {
      name = "camera",
      camera = scene.camera { name = "main", fov = math.deg(2 * math.atan(height / 2 / 1000)), near = 0.1 },
    },
  },
}
