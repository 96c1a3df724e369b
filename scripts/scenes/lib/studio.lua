-- SPDX-License-Identifier: MIT
-- Shared parts of the scenes in scenes/objects: a perspective camera that converts pixels to metres at a point, a wall with
-- protruding blocks of many colours, a checkered floor, and a sun with a sky.
local scene = require "strobe.scene"

local node, material, srgb = scene.node, scene.material, scene.srgb
local studio = {}

-- Returns a camera at `eye` that looks at `aim`, with the vertical field of view `fov`, degrees. Reads the parameters that
-- these scenes share: size of the picture, frame rate and exposure. Displacements are over this exposure.
function studio.open(eye, aim, fov)
  local self = {
    width = scene.param("width", 480), height = scene.param("height", 270),
    fps = scene.param("fps", 24), exposure = scene.param("exposure", 0.5),
    eye = eye, aim = aim, fov = fov,
  }
  self.focal_px = self.height / 2 / math.tan(math.rad(fov / 2))
  return setmetatable(self, { __index = studio })
end

-- Distance from the eye to `point` along the view direction, metres.
function studio:depth(point)
  local length, along = 0, 0
  for i = 1, 3 do
    local forward = self.aim[i] - self.eye[i]
    length, along = length + forward * forward, along + forward * (point[i] - self.eye[i])
  end
  return along / math.sqrt(length)
end

-- Width of one pixel at `point`, across the view direction, metres.
function studio:metres_per_pixel(point) return self:depth(point) / self.focal_px end

-- Returns the change per second of a quantity that changes by `amount` over the exposure.
function studio:rate(amount) return amount * self.fps / self.exposure end

-- Returns the velocity of an object that moves by `offset` (metres) over the exposure, metres per second.
function studio:velocity(offset)
  return { self:rate(offset[1]), self:rate(offset[2] or 0), self:rate(offset[3] or 0) }
end

-- Returns a function that returns random numbers in [0, 1). The numbers depend only on the seed.
function studio.generator(seed)
  local state = seed * 7919 + 17
  return function()
    state = (state * 1103515245 + 12345) % 2147483648
    return (state // 256) % 65536 / 65536
  end
end

studio.colors = { "#b5573a", "#e0d5bd", "#2f5d50", "#c9a25a", "#27405e", "#8a8f94", "#7c2d2a", "#6f7f4a", "#f3ead6",
  "#1d2f52" }

function studio.plain(name, color, roughness)
  return material { name = name, color = srgb(color), roughness = roughness or 0.7 }
end

-- Returns a wall with a quilt pattern that faces +z, with protruding blocks. Fields of `given`:
--   name, seed  name of the nodes; seed of the random blocks
--   position    centre of the face of the wall
--   size        { width, height }, metres
--   cell        side of a cell, metres
--   depth       largest distance by which a block protrudes from the wall, metres
--   every       on average, one in `every` cells has a block; nil: 2
function studio.wall(given)
  local random, cell = studio.generator(given.seed or 1), given.cell
  local columns, rows = given.size[1] // cell, given.size[2] // cell
  local paints, parts = {}, {}
  for i, color in ipairs(studio.colors) do paints[i] = studio.plain("block " .. i, color, 0.85) end
  for row = 0, rows - 1 do
    for column = 0, columns - 1 do
      local is_there, paint = random() * (given.every or 2) < 1, paints[1 + math.floor(random() * #paints)]
      local wide, tall = cell * (0.35 + 0.6 * random()), cell * (0.35 + 0.6 * random())
      local deep = given.depth * (0.15 + 0.85 * random())
      if is_there then
        parts[#parts + 1] = { shape = scene.box { size = { wide, tall, deep } }, material = paint,
          position = { (column + 0.5) * cell - given.size[1] / 2, (row + 0.5) * cell - given.size[2] / 2, deep / 2 } }
      end
    end
  end
  local quilt = material { name = "wall", roughness = 0.95, color_texture = scene.use {
    texture = scene.texture.quilt { colors = { srgb "#9fb0a4", srgb "#44584e", srgb "#d8cdb8" }, count = 8, line = 0.14 },
    scale = { given.size[1] / (8 * cell), given.size[2] / (8 * cell) },
  } }
  return {
    node { name = given.name, position = given.position, shape = scene.quad { size = given.size }, material = quilt },
    node { name = given.name .. "_blocks", position = given.position, parts = parts },
  }
end

-- Returns a checkered floor. Fields of `given`: name; y, z (position); size = { x, z }; cell (side of a cell, metres); colors.
function studio.floor(given)
  local colors = given.colors or { "#8d8672", "#4c4a45" }
  return node {
    name = given.name or "floor", position = { 0, given.y or 0, given.z or 0 }, rotation = { -90, 0, 0 },
    shape = scene.quad { size = given.size },
    material = material { name = given.name or "floor", roughness = 0.8, color_texture = scene.use {
      texture = scene.texture.checker { colors = { srgb(colors[1]), srgb(colors[2]) }, count = 8 },
      scale = { given.size[1] / (8 * given.cell), given.size[2] / (8 * given.cell) },
    } },
  }
end

-- Returns the scene of the nodes and lists of nodes in `given`, with the camera "main" and a sun. `camera_motion`: motion of
-- the camera; nil: static. `animations`: list of animations, or nil.
function studio:scene(name, given, camera_motion, animations)
  local nodes = {}
  for _, entry in ipairs(given) do
    if entry.kind then nodes[#nodes + 1] = entry
    else table.move(entry, 1, #entry, #nodes + 1, nodes) end
  end
  nodes[#nodes + 1] = node { name = "sun", rotation = { -42, -35, 0 },
    light = scene.directional_light { color = srgb "#ffe2b8", intensity = 3.2 } }
  nodes[#nodes + 1] = node { name = "camera", position = self.eye, look_at = self.aim, motion = camera_motion,
    camera = scene.camera { name = "main", fov = self.fov, near = 0.05 } }
  return scene {
    name = name, nodes = nodes, animations = animations,
    environment = { sky = { 0.5, 0.54, 0.62 }, ground = { 0.28, 0.25, 0.21 } },
    shot = { width = self.width, height = self.height, fps = self.fps, frame = 0, exposure = self.exposure },
  }
end

return studio
