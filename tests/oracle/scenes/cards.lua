-- SPDX-License-Identifier: MIT
-- Up to three flat cards k = 0, 1, 2 before a static wall at z = -50. Each card covers the columns [left, right) at
-- height `z` (larger is nearer; the camera is at 100) with brightness `v`, and moves by `d` pixels over the exposure.
local scene = require "strobe.scene"
local pixels = require "scripts.scenes.lib.pixels"

local picture = pixels.picture(128, 8)
local nodes = {
  pixels.rectangle(picture, "wall", { -80, -8, picture.width + 80, picture.height + 8 },
    -50, pixels.flat("wall", scene.param("wall", 0.1))),
}
for k = 0, 2 do
  local left, right = scene.param("left" .. k, 0), scene.param("right" .. k, 0)
  local z, v, d = scene.param("z" .. k, -k), scene.param("v" .. k, 0.5), scene.param("d" .. k, 0)
  if left < right then
    nodes[#nodes + 1] = pixels.rectangle(picture, "card" .. k, { left, -8, right, picture.height + 8 }, z,
      pixels.flat("card" .. k, v), pixels.motion(picture, d))
  end
end
return pixels.scene(picture, "cards", nodes)
