-- SPDX-License-Identifier: MIT
-- Parallel planes behind each other, for a pinhole camera at the origin that looks along -z, with a focal length of
-- `height` / 2 px. Plane k meets the axis at depth d = 10 * scale * (1 + k * gap) and recedes to the right: d + slope *
-- x. Behind the planes is a parallel wall of brightness 1, at depth 20 * scale.
-- split = 1: each plane is an instance, with brightness v0 to v3. split = 0: all planes are one instance.
local scene = require "strobe.scene"

for _, side in ipairs { "width", "height" } do scene.param(side, 16) end -- given to every scene, but not used here
local scale, gap, slope = scene.param("scale", 1), scene.param("gap", 1e-3), scene.param("slope", 0)
local split, count = scene.param("split", 0), scene.param("count", 4)
local values = {}
for k = 0, 3 do values[k] = scene.param("v" .. k, 0.5) end

local extent = 100 * scale -- beyond the picture
local function plane(positions, indices, depth)
  for _, corner in ipairs { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } } do
    local x, y = corner[1] * extent, corner[2] * extent
    positions[#positions + 1] = { x, y, -(depth + slope * x) }
  end
  local first = #positions - 3
  for _, i in ipairs { 0, 1, 2, 0, 2, 3 } do indices[#indices + 1] = first + i end
end

local function card(name, depths, value)
  local positions, indices = {}, {}
  for _, depth in ipairs(depths) do plane(positions, indices, depth) end
  return scene.node {
    name = name, shape = scene.triangles { positions = positions, indices = indices },
    material = scene.material { name = name, color = { value, value, value }, unlit = true },
  }
end

local depths, nodes = {}, {}
for k = 0, count - 1 do depths[#depths + 1] = 10 * scale * (1 + k * gap) end
if split == 1 then
  for k, depth in ipairs(depths) do nodes[k] = card("plane" .. k, { depth }, values[k - 1]) end
else
  nodes[1] = card("planes", depths, values[0])
end
nodes[#nodes + 1] = card("wall", { 20 * scale }, 1)
nodes[#nodes + 1] = scene.node {
  name = "camera", camera = scene.camera { name = "main", fov = 90, near = 0.1 * scale },
}

return scene { name = "layers", nodes = nodes }
