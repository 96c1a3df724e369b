-- SPDX-License-Identifier: MIT
-- Simple shapes with screen paths and coverage in closed form, so that the exact picture is known. A pinhole camera at
-- the origin looks along -z with a focal length of `focal` px. Lengths are in metres, motions in metres over an exposure of
-- half a frame at 24 frames per second. The parameter `kind` selects the shapes:
--      0  the sky only
--      1  a floor `depth` below the camera, `extent` wide
--      2  a card, 4 x 4, at `depth` in front of the camera, and a wall at 4 times this depth
--      3  the card of kind 2 and a second card, which is `gap` farther away and half a width to the right. Both are rotated by
--         `lean` degrees about the vertical axis through the middle of the first card. order = -1: the second card is listed
--         first
--      4  a ball of radius `depth` around the camera, in a room 8 times as large
--      5  one triangle that covers the picture, with a corner behind the camera
--      6  the card of kind 2 with 150 more triangles without area, a mesh that has only triangles without area, and a node
--         without triangles
--      7  the card of kind 2 in front of a wall of the same colour
--      8  `count` x `count` leaves, each a separate instance
--      9  a ball of `count` x `count` triangles
-- Further parameters:
-- aside               shift of the card of kind 2 to the right, metres
-- velocity_x, _y, _z  motion of the shapes, metres over the exposure; walls and the room are static
-- camera_x, _y, _z    motion of the camera, metres over the exposure
-- turn                rotation of the camera to its left, degrees over the exposure
local scene = require "strobe.scene"

local param = scene.param
local width, height, focal = param("width", 48), param("height", 32), param("focal", 32)
local kind, depth, gap, extent = param("kind", 2), param("depth", 4), param("gap", 0), param("extent", 100)
local lean = math.rad(param("lean", 0))
local near, value, orthographic = param("near", 0.1), param("value", 0.9), param("orthographic", 0)
local per_second = 24 / 0.5

local function motion(name)
  local v = {}
  for i, axis in ipairs { "x", "y", "z" } do v[i] = param(name .. "_" .. axis, 0) * per_second end
  return v
end
local moves, camera_moves, turn = motion "velocity", motion "camera", param("turn", 0)

local function flat(name, grey)
  return scene.material { name = name, color = { grey, grey, grey }, unlit = true }
end

local function card(name, x, z, grey)
  return scene.node {
    name = name, position = { x * math.cos(lean), 0, z - x * math.sin(lean) }, rotation = { 0, math.deg(lean), 0 },
    shape = scene.quad { size = { 4, 4 } }, material = flat(name, grey),
    motion = { velocity = moves },
  }
end

local wall_size = 64 * depth
local function wall(grey)
  return scene.node {
    name = "wall", position = { 0, 0, -4 * depth }, shape = scene.quad { size = { wall_size, wall_size } },
    material = flat("wall", grey),
  }
end

local kinds = {
  [0] = function() return {} end,
  function()
    return { scene.node {
      name = "floor", position = { 0, -depth, 0 }, rotation = { -90, 0, 0 },
      shape = scene.quad { size = { extent, extent } }, motion = { velocity = moves },
      material = scene.material { name = "floor", unlit = true, color_texture = scene.texture.checker {
        size = { 64, 64 }, colors = { { 0.9, 0.9, 0.9 }, { 0.3, 0.3, 0.3 } }, count = 16 } },
    } }
  end,
  function() return { wall(0.2), card("card", param("aside", 0), -depth, value) } end,
  function()
    local first, second = card("card", 0, -depth, value), card("twin", 2, -depth - gap, 0.5)
    if param("order", 1) < 0 then first, second = second, first end
    return { wall(0.2), first, second }
  end,
  function()
    return {
      scene.node { name = "room", shape = scene.box { size = { 16 * depth, 16 * depth, 16 * depth } },
        material = flat("room", 0.2) },
      scene.node { name = "ball", shape = scene.sphere { radius = depth }, material = flat("ball", value),
        motion = { velocity = moves } },
    }
  end,
  function()
    return { scene.node {
      name = "triangle", material = flat("triangle", value), motion = { velocity = moves },
      shape = scene.triangles {
        positions = { { -400 * depth, -300 * depth, -7 * depth }, { 400 * depth, -300 * depth, -7 * depth },
                      { 0, 500 * depth, 9 * depth } } },
    } }
  end,
  function()
    local positions = { { -2, -2, 0 }, { 2, -2, 0 }, { 2, 2, 0 }, { -2, 2, 0 } }
    local indices = { 1, 2, 3, 1, 3, 4 }
    for i = 1, 50 do
      local a, b = 1 + i % 4, 1 + (i + 1) % 4
      for _, corner in ipairs { a, a, a, a, b, b, a, b, a } do indices[#indices + 1] = corner end
    end
    return {
      wall(0.2),
      scene.node { name = "card", position = { 0, 0, -depth }, material = flat("card", value),
        shape = scene.triangles { positions = positions, indices = indices }, motion = { velocity = moves } },
      scene.node { name = "empty" },
      scene.node { name = "points", position = { 0, 0, -depth / 2 }, material = flat("points", 1),
        shape = scene.triangles {
          positions = { { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 }, { 1, 1, 0 }, { 2, 2, 0 }, { 3, 3, 0 } },
        } },
    }
  end,
  function() return { wall(value), card("card", 0, -depth, value) } end,
  function()
    local list, side = { wall(0.2) }, math.tointeger(param("count", 64))
    for i = 0, side * side - 1 do
      local x, y = (i % side + 0.5) / side - 0.5, (i // side + 0.5) / side - 0.5
      list[#list + 1] = scene.node {
        name = "leaf" .. i, position = { 2 * x * depth, 2 * y * depth, -depth - 0.01 * depth * (i % 7) },
        rotation = { 0, 0, i * 37 % 360 }, shape = scene.quad { size = { 1.5 / side * depth, 1.5 / side * depth } },
        material = flat("leaf" .. i % 5, 0.3 + 0.1 * (i % 5)), motion = { velocity = moves },
      }
    end
    return list
  end,
  function()
    return { wall(0.2), scene.node {
      name = "ball", position = { 0, 0, -depth }, material = flat("ball", value), motion = { velocity = moves },
      shape = scene.sphere { radius = depth / 2, segments = math.tointeger(param("count", 1000)) } } }
  end,
}

local nodes = kinds[math.tointeger(kind)]()
local lens = orthographic ~= 0
    and scene.orthographic_camera { name = "main", half_height = height / 2 / focal * depth, near = near }
    or scene.camera { name = "main", fov = math.deg(2 * math.atan(height / 2 / focal)), near = near }
nodes[#nodes + 1] = scene.node {
  name = "camera", camera = lens,
  motion = { velocity = camera_moves, axis = { 0, 1, 0 }, degrees_per_second = turn * per_second },
}

return scene {
  name = "planes", nodes = nodes, environment = { background = { 0.25, 0.5, 1 } },
  shot = { width = width, height = height, fps = 24, frame = 0, exposure = 0.5 },
}
