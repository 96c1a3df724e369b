-- SPDX-License-Identifier: MIT
-- Random cards and solids in front of a wall. `strobe stability` uses this scene to test invariants: properties that every blur
-- has, for any picture. The parameter `seed` chooses the objects. Every other parameter changes one thing with a known effect
-- on the picture.
-- Units: positions are in pixels from the middle of the picture (x right, y down), displacements in pixels over an exposure of
-- half a frame at 24 frames per second. One pixel spans 1/8 m for the orthographic camera and depth / 64 for the perspective
-- camera.
-- Positions: the distance of a silhouette from a pixel edge is an odd multiple of 1/8 px. So no silhouette passes through the
-- centre of a pixel, even if the scene is mirrored.
-- Displacements: each component is p / 16 px, with a prime p of at least 37. So with up to 33 taps, no tap falls
-- exactly between two pixels, where rounding would decide. No two moving objects have equally long displacements. With
-- `ties` = 1, components are whole pixels, so that many taps fall exactly between two pixels.
local scene = require "strobe.scene"

local param = scene.param
local width, height = param("width", 64), param("height", 40)
local seed, cards, boxes, balls = param("seed", 1), param("cards", 5), param("boxes", 0), param("balls", 0)
local reach, ties, spin = param("reach", 10), param("ties", 0), param("spin", 0)
local inside = param("inside", -1)             -- smallest distance of cards from the border, px; -1: cards may cross it
local textured, lit, wall = param("textured", 1), param("lit", 1), param("wall", 1)
local perspective = param("perspective", 1)
local speed, scale, brightness = param("speed", 1), param("scale", 1), param("brightness", 1)
-- mirror = -1 mirrors the picture left to right, flip = -1 top to bottom. turn = 1 then turns it to the left by 90 degrees.
local mirror, flip, turn = param("mirror", 1), param("flip", 1), param("turn", 0)
local shift_x, shift_y = param("shift_x", 0), param("shift_y", 0)                  -- shift of all objects, px
local pan_x, pan_y = param("pan_x", 0), param("pan_y", 0)                          -- motion of all objects, px/exposure
-- order: seed of a permutation of the objects and of the triangles of each rectangle; 0: no permutation. peel: number of
-- nearest objects that are left out.
local order, peel = param("order", 0), param("peel", 0)
local value = param("value", 0)                          -- colour of all objects; 0: random colours
local first, second = param("first", 1), param("second", 1)  -- weights of the two terms that add up to each colour
-- Radiance of the nearest card: `hot` times the absolute value of `hot_scale`. With hot = 0, the card is like the other cards.
-- If `hot_scale` is negative, the card is a lit metal; otherwise it is unlit. A metal has no diffuse reflection, so shading
-- multiplies its colour by 0. If the colour is infinite, this product is not a number.
local hot, hot_scale = param("hot", 0), param("hot_scale", 1)

local exposures_per_second = 24 / 0.5
local wall_depth = 32

-- Returns a random number in [0, 1) that depends only on the seed, the object's number `i` and the name of the quantity.
local function random(i, name)
  local state = math.tointeger(seed) * 0x9E3779B97F4A7C15 + i * 0xD1B54A32D192ED03
  for k = 1, #name do state = (state ~ name:byte(k)) * 0x100000001B3 end
  state = (state ~ (state >> 32)) * 0xD6E8FEB86659FD93
  state = (state ~ (state >> 32)) * 0xD6E8FEB86659FD93
  return ((state ~ (state >> 32)) >> 11 & 0xFFFFFFFFFFFFF) / 2 ^ 52
end

-- Returns a random whole number from `low` to `high`.
local function whole(i, name, low, high) return low + math.floor(random(i, name) * (high - low + 1)) end

-- Returns a random permutation of 1..count that depends on `order`; the identity if `order` is 0.
local function permutation(count, name)
  local list = {}
  for i = 1, count do list[i] = i end
  for i = count, 2, -1 do
    local j = order == 0 and i or 1 + math.floor(random(i, name .. order) * i)
    list[i], list[j] = list[j], list[i]
  end
  return list
end

local function permuted(list, name)
  local result = {}
  for i, from in ipairs(permutation(#list, name)) do result[i] = list[from] end
  return result
end

-- ---- places

local function depth_of(i) return wall_depth * 0.8125 ^ i end

local function pixel_at(depth) return (perspective ~= 0 and depth / 64 or 1 / 8) * scale end

-- Returns the direction (x, y) as it is after the picture is mirrored and turned.
local function placed(x, y)
  x, y = mirror * x, flip * y
  if turn ~= 0 then x, y = y, -x end
  return x, y
end

-- World position of the point (x, y) px from the middle of the picture, at `depth`, metres.
local function position(x, y, depth)
  local pixel = pixel_at(depth)
  x, y = placed(x + shift_x, y + shift_y)
  return { x * pixel, -y * pixel, -depth * scale }
end

local function motion(dx, dy, depth)
  local rate = pixel_at(depth) * exposures_per_second
  local x, y = placed(dx * speed + pan_x, dy * speed + pan_y)
  return { x * rate, -y * rate, 0 }
end

-- ---- looks

-- Returns the colour of an object: the sum of two random terms with the weights `first` and `second`. Tests of linearity render
-- each term alone and both together. The terms are multiples of 1/64, so that their sum is exact.
local function color_of(i, name)
  local color = {}
  for c = 1, 3 do
    local a, b = whole(i, name .. "a" .. c, 2, 40) / 64, whole(i, name .. "b" .. c, 2, 24) / 64
    color[c] = (first * a + second * b) * brightness
  end
  return color
end

local function material(i, name)
  if value ~= 0 then
    local texel = scene.texture.texels { width = 1, height = 1, texels = { { value, value, value } } }
    return scene.material { name = name, color_texture = texel, unlit = true }
  end
  if lit == 0 then return scene.material { name = name, color = color_of(i, name), unlit = true } end
  return scene.material { name = name, color = color_of(i, name), roughness = 0.5 }
end

-- Returns a material with a radiance beyond the range of colours. The radiance is the product of a texel, `hot`, and a colour,
-- |hot_scale|. If `hot_scale` is negative, the material is lit metal, so that shading multiplies its colour by 0.
local function hot_material()
  local texel = scene.texture.texels { width = 1, height = 1, texels = { { hot, hot, hot } } }
  local factor = math.abs(hot_scale)
  return scene.material {
    name = "hot", color = { factor, factor, factor }, color_texture = texel, unlit = hot_scale >= 0, metallic = 1,
  }
end

-- ---- shapes

-- A rectangle of `w` x `h` px of four triangles. The parameter `order` permutes the triangles, which must not change the
-- picture.
local function rectangle(w, h, depth, name)
  local pixel = pixel_at(depth)
  local x, y = w * pixel / 2, h * pixel / 2
  local positions = { { -x, -y, 0 }, { 0, -y, 0 }, { x, -y, 0 }, { -x, y, 0 }, { 0, y, 0 }, { x, y, 0 } }
  local triangles = permuted({ { 1, 2, 5 }, { 1, 5, 4 }, { 2, 3, 6 }, { 2, 6, 5 } }, name)
  local indices = {}
  for _, triangle in ipairs(triangles) do
    for _, corner in ipairs(triangle) do indices[#indices + 1] = corner end
  end
  return scene.triangles { positions = positions, indices = indices }
end

-- Returns the stripes of a card, side by side, as parts of one object. The last stripe fills the rest of the card.
local function stripes(i, w, h, depth, name)
  local across = random(i, "across") < 0.5
  local long, parts, from = across and w or h, {}, 0
  while from < long do
    local size = math.min(whole(i, "stripe" .. #parts, 2, 5), long - from)
    local middle = from + size / 2 - long / 2
    local x, y = placed(across and middle or 0, across and 0 or middle)
    local sides = across and { size, h } or { w, size }
    if turn ~= 0 then sides = { sides[2], sides[1] } end
    local pixel = pixel_at(depth)
    parts[#parts + 1] = {
      shape = rectangle(sides[1], sides[2], depth, name .. #parts), position = { x * pixel, -y * pixel, 0 },
      material = material(i, name .. #parts),
    }
    from = from + size
  end
  return permuted(parts, name)
end

local primes = { 37, 41, 43, 47, 53, 59, 61, 67, 71, 73, 79, 83, 89, 97, 101, 103, 107, 109, 113, 127, 131, 137, 139,
  149, 151, 157, 163, 167, 173, 179, 181, 191, 193, 197, 199, 211, 223, 227, 229, 233, 239, 241, 251, 257 }

-- Returns the displacement of object number i, px over the exposure, at most `reach` px long. Every fifth displacement is 0,
-- and every third displacement is along an axis.
local used = {}
local function displacement(i)
  if i % 5 == 4 then return 0, 0 end
  for try = 1, 200 do
    local function component(axis)
      local sign = random(i, axis .. "sign" .. try) < 0.5 and -1 or 1
      if ties ~= 0 then return sign * whole(i, axis .. try, 1, math.max(1, math.floor(reach))) end
      return sign * primes[whole(i, axis .. try, 1, #primes)] / 16
    end
    local dx, dy = component "x", component "y"
    if i % 3 == 0 then
      if random(i, "axis") < 0.5 then dx = 0 else dy = 0 end
    end
    local squared = dx * dx + dy * dy
    if squared <= reach * reach and not used[squared] then
      used[squared] = true
      return dx, dy
    end
  end
  return 0, 0
end

-- Returns a random coordinate of an object's centre, px. Its distance from pixel edges is an odd multiple of 1/8 px. If
-- `inside` is at least 0, an object of half-size `half` stays within a picture of the size `side`.
local function coordinate(i, name, side, half)
  local range = inside >= 0 and math.max(side / 2 - inside - half, 0) or side / 2
  return math.floor((2 * random(i, name) - 1) * range) + (2 * whole(i, name .. "8", 0, 3) + 1) / 8
end

local function card(i)
  local depth, name = depth_of(i), "card" .. i
  local w, h = whole(i, "w", 3, math.max(4, width // 4)), whole(i, "h", 3, math.max(4, height // 3))
  local dx, dy = displacement(i)
  local away = inside >= 0 and reach + 1 or 0
  local x = coordinate(i, "x", width, w / 2 + away)
  local y = coordinate(i, "y", height, h / 2 + away)
  local sides = turn ~= 0 and { h, w } or { w, h }
  local fields = {
    name = name, position = position(x, y, depth), motion = { velocity = motion(dx, dy, depth) },
  }
  if spin ~= 0 then
    fields.motion.axis, fields.motion.degrees_per_second = { 0, 0, 1 }, (random(i, "spin") - 0.5) * 60 * speed * 48
  end
  if hot ~= 0 and i == cards then
    fields.shape, fields.material = rectangle(sides[1], sides[2], depth, name), hot_material()
  elseif textured ~= 0 and i % 2 == 1 then
    fields.parts = stripes(i, w, h, depth, name)
  else
    fields.shape, fields.material = rectangle(sides[1], sides[2], depth, name), material(i, name)
  end
  return scene.node(fields)
end

-- Returns a box that is turned about the vertical, or a ball, behind the cards.
local function solid(i, is_ball)
  local depth, name = wall_depth * (is_ball and 0.9 or 0.95) - i, (is_ball and "ball" or "box") .. i
  local pixel = pixel_at(depth)
  local x, y = whole(i, name .. "x", -width // 2, width // 2) + 0.375, whole(i, name .. "y", -height // 3, height // 3) + 0.125
  local dx, dy = displacement(i + 64)
  local size = whole(i, name .. "size", 5, 9) * pixel
  local angle = 20 + 50 * random(i, name .. "angle")
  local turned = turn ~= 0 and { -angle * mirror, 0, 0 } or { 0, angle * mirror, 0 }  -- with `turn`, the axis is horizontal
  return scene.node {
    name = name, position = position(x, y, depth), motion = { velocity = motion(dx, dy, depth) }, rotation = turned,
    shape = is_ball and scene.sphere { radius = size / 2 } or scene.box { size = { size, size, size } },
    material = material(i, name),
  }
end

local function wall_node()
  local name, depth = "wall", wall_depth
  local w, h = 8 * (width + height), 8 * (width + height)
  local x, y = 0.125, 0.125
  if wall == 2 then w, h, x, y = width // 2 + 3, height // 2 + 5, 5.375, 3.625 end
  return scene.node {
    name = name, position = position(x, y, depth), motion = { velocity = motion(0, 0, depth) },
    shape = rectangle(turn ~= 0 and h or w, turn ~= 0 and w or h, depth, name), material = material(0, name),
  }
end

-- ---- scene

local objects = {}
if wall ~= 0 then objects[1] = wall_node() end
for i = 1, math.tointeger(boxes) do objects[#objects + 1] = solid(i, false) end
for i = 1, math.tointeger(balls) do objects[#objects + 1] = solid(i, true) end
for i = 1, math.tointeger(cards) do objects[#objects + 1] = card(i) end
for _ = 1, math.min(math.tointeger(peel), #objects) do objects[#objects] = nil end
objects = permuted(objects, "objects")

local lamp_x, lamp_y = placed(1 + shift_x / 8, -4 + shift_y / 8)
if lit ~= 0 then
  objects[#objects + 1] = scene.node {
    name = "lamp", position = { lamp_x * scale, -lamp_y * scale, 2 * scale },
    light = scene.point_light { intensity = 900 * scale * scale * brightness },
  }
end

local half = perspective ~= 0 and height / 2 / 64 or height / 2 / 8 * scale
local lens = perspective ~= 0
    and scene.camera { name = "main", fov = math.deg(2 * math.atan(half)), near = 0.5 * scale }
    or scene.orthographic_camera { name = "main", half_height = half, near = 0.5 * scale }
objects[#objects + 1] = scene.node { name = "camera", camera = lens }

local sky = value ~= 0 and math.min(value, 1e6) or 0.25 * brightness * (first + second) / 2
return scene {
  name = "crowd", nodes = objects,
  environment = { background = { sky, sky, sky }, sky = { sky, sky, sky }, ground = { sky, sky, sky } },
  shot = { width = width, height = height, fps = 24, frame = 0, exposure = 0.5 },
}
