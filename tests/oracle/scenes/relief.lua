-- SPDX-License-Identifier: MIT
-- A height field with a given depth at the centre of each pixel: a mesh with a vertex at each centre, viewed along its
-- axis from a distance of 100. x and y are pixels from the picture's centre; u = x cos(angle) + y sin(angle).
-- field 0: a wave, 100 (1 + step cos(k u)).
-- field 1: a step, 100 where u <= 0, 100 (1 + step) beyond.
-- field 2: two vertical steps. The step at column 20 has height `step` above row 4, changes to `weak` down to row 28,
-- and is `weak` below. The step at column 44 has height `weak`.
local scene = require "strobe.scene"
local pixels = require "scripts.scenes.lib.pixels"

local picture = pixels.picture(64, 64)
local field, step, weak = scene.param("field", 0), scene.param("step", 0.02), scene.param("weak", 0.07)
local k, angle = scene.param("k", 0.9), math.rad(scene.param("angle", 0))

local depths = {
  [0] = function(_, _, u) return 100 * (1 + step * math.cos(k * u)) end,
  [1] = function(_, _, u) return u <= 1e-6 and 100 or 100 * (1 + step) end,
  [2] = function(column, row)
    local first = column < 20 and 0 or step + (weak - step) * math.max(0, math.min(1, (row - 4) / 24))
    return 100 * (1 + first) * (column < 44 and 1 or 1 + weak)
  end,
}

local positions, indices = {}, {}
local columns = picture.width + 2
for row = -1, picture.height do
  for column = -1, picture.width do
    local x, y = column + 0.5 - picture.width / 2, row + 0.5 - picture.height / 2
    local u = (column - picture.width // 2) * math.cos(angle) + (row - picture.height // 2) * math.sin(angle)
    positions[#positions + 1] = { x, -y, 100 - depths[math.tointeger(field)](column, row, u) }
  end
end
for row = 0, picture.height do
  for column = 0, picture.width do
    local corner = row * columns + column + 1
    for _, offset in ipairs { 0, columns, columns + 1, 0, columns + 1, 1 } do
      indices[#indices + 1] = corner + offset
    end
  end
end

return pixels.scene(picture, "relief", {
  scene.node {
    name = "relief", shape = scene.triangles { positions = positions, indices = indices },
    material = pixels.flat("relief", 0.5),
  },
})
