-- SPDX-License-Identifier: MIT
-- Shared parts of the scenes that test extreme values: a camera that looks along -z, and unlit panels of coloured cells. A
-- panel is given by pixel positions and depths: the corners of its cells lie on the camera rays through given pixels. So a
-- panel looks the same at any depth, tilt or scale, and the correct picture is known.
local scene = require "strobe.scene"

local stage = {}

-- Reads the parameters that these scenes share: size of the picture; frame rate and exposure (displacements are over this
-- exposure); `scale`, a factor on all lengths; `offset`, a translation of the whole scene along each axis of the world, metres.
function stage.open()
  local self = {
    width = scene.param("width", 320), height = scene.param("height", 180),
    fps = scene.param("fps", 24), exposure = scene.param("exposure", 0.5),
    scale = scene.param("scale", 1), offset = scene.param("offset", 0), fov = 60,
  }
  self.focal_px = self.height / 2 / math.tan(math.rad(self.fov / 2))
  return setmetatable(self, { __index = stage })
end

-- Returns the point at `depth` (metres, before scaling) on the camera ray through the pixel position (x, y), in camera space.
function stage:point(x, y, depth)
  local along = depth * self.scale
  return { (x - self.width / 2) / self.focal_px * along, (self.height / 2 - y) / self.focal_px * along, -along }
end

-- Returns the position in the world of `point`, a point in camera space.
function stage:placed(point)
  return { point[1] + self.offset, point[2] + self.offset, point[3] + self.offset }
end

-- Returns the velocity of an object at `depth` that moves by (dx, dy) px over the exposure, metres per second.
function stage:velocity(dx, dy, depth)
  local metres = depth * self.scale / self.focal_px * self.fps / self.exposure
  return { dx * metres, -dy * metres, 0 }
end

-- Returns a pseudorandom whole number from 1 to `most` for a cell. It selects the cell's colour, in a pattern that does not
-- repeat.
local function drawn(column, row, seed, most)
  local state = (column * 374761393 + row * 668265263 + seed * 362437) % 4294967296
  state = (state ~ (state >> 13)) * 1274126177 % 4294967296
  return (state ~ (state >> 16)) // 7 % most + 1
end

local function added(mesh, corners)
  local first = #mesh.positions
  for _, corner in ipairs(corners) do mesh.positions[#mesh.positions + 1] = corner end
  for _, index in ipairs { 1, 2, 3, 1, 3, 4 } do mesh.indices[#mesh.indices + 1] = first + index end
end

-- Returns a panel of coloured cells. Fields of `given`:
--   name, colors, seed, motion  name of the node; list of colours; seed of the pattern; motion of the node
--   edges   { left, top, right, bottom }, px
--   cell    side of a cell, px
--   slant   shift to the right, px, per pixel downwards; a slanted edge passes pixel centres at all sub-pixel distances
--   depth   depth of all corners, or a function that returns the depth at a position x (px), metres
--   at      position of the node in camera space; nil: the camera's position
function stage:panel(given)
  local left, top, right, bottom = table.unpack(given.edges)
  local at, meshes = given.at or { 0, 0, 0 }, {}
  for i = 1, #given.colors do meshes[i] = { positions = {}, indices = {} } end
  local function corner(x, y)
    local slanted = x + (given.slant or 0) * (y - (top + bottom) / 2)
    local depth = type(given.depth) == "function" and given.depth(slanted) or given.depth
    local point = self:point(slanted, y, depth)
    return { point[1] - at[1], point[2] - at[2], point[3] - at[3] }
  end
  for y = top, bottom - 1, given.cell do
    for x = left, right - 1, given.cell do
      local x1, y1 = math.min(x + given.cell, right), math.min(y + given.cell, bottom)
      local color = drawn((x - left) // given.cell, (y - top) // given.cell, given.seed, #given.colors)
      added(meshes[color], { corner(x, y1), corner(x1, y1), corner(x1, y), corner(x, y) })
    end
  end
  local parts = {}
  for i, mesh in ipairs(meshes) do
    if #mesh.positions > 0 then
      parts[#parts + 1] = {
        shape = scene.triangles(mesh),
        material = scene.material { name = ("%s_%d"):format(given.name, i), color = given.colors[i], unlit = true },
      }
    end
  end
  return scene.node { name = given.name, position = self:placed(at), motion = given.motion, parts = parts }
end

stage.warm = { { 0.9, 0.35, 0.1 }, { 0.95, 0.75, 0.2 }, { 0.6, 0.08, 0.12 } }
stage.cold = { { 0.05, 0.12, 0.35 }, { 0.25, 0.55, 0.7 }, { 0.02, 0.05, 0.08 }, { 0.45, 0.7, 0.55 } }

-- Returns the scene of the given nodes and the camera. `near`: depth of the near plane before scaling, metres.
function stage:scene(name, nodes, near)
  nodes[#nodes + 1] = scene.node {
    name = "camera", position = self:placed { 0, 0, 0 },
    camera = scene.camera { name = "main", fov = self.fov, near = near * self.scale },
  }
  return scene {
    name = name, nodes = nodes, environment = { background = { 0, 0, 0 } },
    shot = { width = self.width, height = self.height, fps = self.fps, frame = 0, exposure = self.exposure },
  }
end

return stage
