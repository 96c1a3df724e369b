-- SPDX-License-Identifier: MIT
-- Pieces of furniture for scenes. Each function takes a table of position, sizes and materials, and returns a list of nodes.
local scene  = require "strobe.scene"
local studio = require "scripts.scenes.lib.studio"

local node, srgb = scene.node, scene.srgb
local furniture = {}

-- Returns `point`, moved by the vector `by`.
local function plus(point, by) return { point[1] + by[1], point[2] + by[2], point[3] + by[3] } end

-- A sofa whose seat faces +z: base, legs, arms, three seats and three backs.
function furniture.sofa(given)
  local at, fabric, width = given.position, given.fabric, given.width
  local inner = width - 0.36
  local function piece(name, size, by, radius, turn)
    return node {
      name = "sofa_" .. name, material = fabric, position = plus(at, by), rotation = turn,
      shape = scene.box { size = size, radius = radius, segments = 5, tile = 0.6 },
    }
  end
  local legs = {}
  for i = 0, 3 do
    legs[i + 1] = {
      shape = scene.cylinder { radius = 0.018, top_radius = 0.028, height = 0.14, segments = 20 },
        material = given.wood,
      position = { (i % 2 * 2 - 1) * (width / 2 - 0.1), 0.07, (i // 2 * 2 - 1) * 0.34 },
    }
  end
  local nodes = {
    node { name = "sofa_legs", position = at, parts = legs },
    piece("base", { width - 0.04, 0.2, 0.84 }, { 0, 0.24, 0 }, 0.03),
    piece("rail", { width - 0.1, 0.5, 0.2 }, { 0, 0.5, -0.36 }, 0.07),
    piece("arm_left", { 0.2, 0.46, 0.86 }, { -width / 2 + 0.09, 0.38, 0.01 }, 0.08),
    piece("arm_right", { 0.2, 0.46, 0.86 }, { width / 2 - 0.09, 0.38, 0.01 }, 0.08),
  }
  for i = -1, 1 do
    local x = i * inner / 3
    nodes[#nodes + 1] = piece("seat_" .. i + 2, { inner / 3 - 0.008, 0.16, 0.66 }, { x, 0.42, 0.08 }, 0.05)
    nodes[#nodes + 1] = piece("back_" .. i + 2, { inner / 3 - 0.012, 0.42, 0.17 }, { x, 0.68, -0.2 }, 0.075,
      { -11, 0, 0 })
  end
  return nodes
end

function furniture.coffee_table(given)
  local at, size = given.position, given.size
  local legs = {}
  for i = 0, 3 do
    local x, z = (i % 2 * 2 - 1) * (size[1] / 2 - 0.08), (i // 2 * 2 - 1) * (size[3] / 2 - 0.07)
    legs[i + 1] = {
      material = given.metal,
      shape = scene.tube { path = { { x * 1.06, 0, z * 1.1 }, { x * 0.95, size[2] - 0.03, z * 0.9 } }, radius = 0.012 },
    }
  end
  return {
    node { name = "table_top", material = given.wood, position = plus(at, { 0, size[2] - 0.018, 0 }),
           shape = scene.box { size = { size[1], 0.036, size[3] }, radius = 0.014, segments = 6 } },
    node { name = "table_legs", position = at, parts = legs },
    node { name = "table_shelf", material = given.wood, position = plus(at, { 0, 0.14, 0 }),
           shape = scene.box { size = { size[1] - 0.2, 0.018, size[3] - 0.16 }, radius = 0.006 } },
  }
end

-- A window frame of bars, which fills an opening in a wall that extends along z. `size`: { width along z, height }, metres.
function furniture.window(given)
  local width, height = given.size[1], given.size[2]
  local parts = {}
  local function bar(size, position)
    parts[#parts + 1] = { shape = scene.box { size = size, radius = 0.006 }, material = given.material,
      position = position }
  end
  for _, side in ipairs { -1, 1 } do
    bar({ 0.09, 0.07, width }, { 0, side * (height / 2 - 0.035), 0 })
    bar({ 0.09, height, 0.07 }, { 0, 0, side * (width / 2 - 0.035) })
    bar({ 0.05, height, 0.045 }, { 0, 0, side * width / 6 })
  end
  bar({ 0.05, 0.035, width }, { 0, 0.1, 0 })
  return node { name = given.name, position = given.position, parts = parts }
end

-- A lamp: an open shade, a bulb with a light inside, a stem and a foot.
local function lamp(prefix, at, shade_height, radius, given, intensity)
  local profile = { { radius, -0.13 }, { radius * 0.72, 0.13 }, { radius * 0.72 - 0.004, 0.13 },
    { radius - 0.004, -0.13 },
                    { radius, -0.13 } }
  return {
    node { name = prefix .. "_shade", material = given.shade, position = plus(at, { 0, shade_height, 0 }),
           shape = scene.lathe { profile = profile, segments = 40 } },
    node { name = prefix .. "_bulb", material = given.bulb, position = plus(at, { 0, shade_height - 0.02, 0 }),
           shape = scene.sphere { radius = 0.028, segments = 16 } },
    node { name = prefix .. "_light", position = plus(at, { 0, shade_height + 0.045, 0 }),
           light = scene.point_light { color = srgb "#ffbf73", intensity = intensity } },
  }
end

function furniture.floor_lamp(given)
  local nodes = lamp(given.name, given.position, 1.5, 0.21, given, 2.2)
  nodes[#nodes + 1] = node {
    name = given.name .. "_stem", position = given.position,
    parts = {
      { shape = scene.cylinder { radius = 0.14, height = 0.024, bevel = 0.008 }, material = given.metal,
        position = { 0, 0.012, 0 } },
      { shape = scene.cylinder { radius = 0.011, height = 1.42, segments = 20 }, material = given.metal,
        position = { 0, 0.73, 0 } },
    },
  }
  return nodes
end

-- A round table with a lamp.
function furniture.side_lamp(given)
  local top = 0.52
  local nodes = lamp("side_lamp", plus(given.position, { 0, top, 0 }), 0.44, 0.17, given, 0.8)
  nodes[#nodes + 1] = node {
    name = "side_lamp_body", material = given.body, position = plus(given.position, { 0, top, 0 }),
    shape = scene.lathe {
      smooth = 4, segments = 40,
      profile = { { 0, 0 }, { 0.06, 0 }, { 0.066, 0.01 }, { 0.085, 0.09 }, { 0.06, 0.19 }, { 0.018, 0.26 },
        { 0.012, 0.36 },
                  { 0, 0.362 } },
    },
  }
  nodes[#nodes + 1] = node {
    name = "side_table", position = given.position,
    parts = {
      { shape = scene.cylinder { radius = 0.25, height = 0.028, bevel = 0.01, segments = 56 }, material = given.wood,
        position = { 0, top - 0.014, 0 } },
      { shape = scene.cylinder { radius = 0.025, height = top - 0.04 }, material = given.wood,
        position = { 0, top / 2, 0 } },
      { shape = scene.cylinder { radius = 0.17, top_radius = 0.15, height = 0.03, bevel = 0.008 },
        material = given.wood, position = { 0, 0.015, 0 } },
    },
  }
  return nodes
end

local spines = { "#7c2d2a", "#27405e", "#2f5d50", "#c9a25a", "#5a4636", "#8a8f94", "#b5573a", "#e0d5bd", "#41304f",
  "#6f7f4a" }

-- Open shelves against a wall at -z, filled with books of random sizes and a few objects.
function furniture.bookshelf(given)
  local at, width, height, depth, boards = given.position, 1.0, 1.9, 0.3, 5
  local parts = {}
  local function board(size, position)
    parts[#parts + 1] = { shape = scene.box { size = size, radius = 0.004, tile = 0.8 }, material = given.wood,
      position = position }
  end
  for _, side in ipairs { -1, 1 } do board({ 0.03, height, depth }, { side * width / 2, height / 2, 0 }) end
  local gap = (height - 0.1) / (boards - 1)
  for i = 0, boards - 1 do board({ width - 0.03, 0.026, depth }, { 0, 0.06 + i * gap, 0 }) end
  local nodes = { node { name = "shelf", position = at, parts = parts } }

  local random = studio.generator(12)
  local function books(shelf, from, to)
    local x, count = from, 0
    local y = 0.06 + shelf * gap + 0.013
    while true do
      local thick, tall, deep = 0.03 + 0.03 * random(), 0.23 + 0.1 * random(), 0.17 + 0.06 * random()
      if x + thick > to then break end
      count = count + 1
      local cover = spines[1 + math.floor(random() * #spines)]
      nodes[#nodes + 1] = node {
        name = ("book_%d_%d"):format(shelf + 1, count),
          shape = scene.box { size = { thick - 0.002, tall, deep }, radius = 0.003, segments = 2 },
        position = plus(at, { x + thick / 2, y + tall / 2, 0.02 }),
        material = scene.material {
          name = "book", roughness = 0.7,
          color_texture = scene.texture.spine {
            size = { 64, 256 }, colors = { srgb(cover), srgb "#d8b45e", srgb "#e9dcb8" }, seed = 1 + count % 4,
          },
        },
      }
      x = x + thick
    end
  end
  books(0, -0.46, 0.1)
  books(1, -0.1, 0.46)
  books(2, -0.46, 0.05)
  books(3, 0.0, 0.44)

  local function on(shelf, x) return plus(at, { x, 0.073 + shelf * gap, 0.03 }) end
  nodes[#nodes + 1] = node { name = "globe", position = on(1, -0.3), parts = {
    { shape = scene.sphere { radius = 0.11, segments = 32 }, position = { 0, 0.15, 0 },
      material = scene.material { name = "globe", roughness = 0.4, color_texture = scene.texture.noise {
        size = { 256, 128 }, colors = { srgb "#2c5f80", srgb "#c2a86a" }, count = { 8, 4 }, amount = 1, seed = 21 } } },
    { shape = scene.cylinder { radius = 0.06, top_radius = 0.015, height = 0.05 }, material = given.brass,
      position = { 0, 0.025, 0 } },
  } }
  nodes[#nodes + 1] = node { name = "shelf_jar", position = on(0, 0.3), material = given.glaze, shape = scene.lathe {
    smooth = 4, profile = { { 0, 0 }, { 0.05, 0 }, { 0.09, 0.07 }, { 0.085, 0.16 }, { 0.045, 0.22 }, { 0.055, 0.25 },
      { 0.045, 0.245 }, { 0.035, 0.22 }, { 0, 0.2 } } } }
  nodes[#nodes + 1] = node { name = "shelf_box", position = plus(on(2, 0.27), { 0, 0.06, 0 }), material = given.wood,
                             shape = scene.box { size = { 0.24, 0.12, 0.18 }, radius = 0.008 } }
  for _, part in ipairs(furniture.plant { name = "shelf_plant", position = on(3, -0.25), pot = given.pot,
    leaf = given.leaf,
                                          leaves = 9, size = 0.32, seed = 5 }) do
    nodes[#nodes + 1] = part
  end
  nodes[#nodes + 1] = node { name = "shelf_sphere", position = plus(on(4, 0.2), { 0, 0.07, 0 }), material = given.brass,
                             shape = scene.torus { radius = 0.07, tube_radius = 0.02 }, rotation = { 90, 20, 0 } }
  return nodes
end

-- A pot with curved leaves. `size`: height of the tallest leaf, metres.
function furniture.plant(given)
  local size, random = given.size, studio.generator(given.seed)
  local pot = size * 0.16
  local leaves = {}
  for i = 1, given.leaves do
    local angle = (i * 137.5 + 30 * random()) * math.pi / 180
    local lean, tall = 0.25 + 0.5 * random(), size * (0.62 + 0.38 * random())
    local x, z = math.cos(angle), math.sin(angle)
    local function at(out, up) return { x * out * size, up, z * out * size } end
    local wide = size * (0.045 + 0.02 * random())
    leaves[i] = {
      material = given.leaf,
      shape = scene.tube {
        path = { at(0.02, 0), at(0.05 + 0.1 * lean, tall * 0.45), at(0.08 + 0.42 * lean, tall * 0.82),
          at(0.1 + 0.85 * lean, tall * (1 - 0.28 * lean)) },
        radii = { size * 0.008, size * 0.02, wide, size * 0.004 }, flatten = 0.08, segments = 10, smooth = 5,
        up = { x * 0.35, 1, z * 0.35 },
      },
    }
  end
  return {
    node { name = given.name .. "_pot", position = given.position, material = given.pot, shape = scene.lathe {
      segments = 40, profile = { { 0, 0 }, { pot * 0.72, 0 }, { pot, pot * 1.7 }, { pot * 1.06, pot * 1.7 },
        { pot * 1.06, pot * 1.95 },
                                 { pot * 0.94, pot * 1.95 }, { pot * 0.9, pot * 1.7 }, { 0, pot * 1.7 } } } },
    node { name = given.name .. "_leaves", position = plus(given.position, { 0, pot * 1.6, 0 }), parts = leaves },
  }
end

-- A painted canvas with a mount in a frame of four bars, facing +z.
function furniture.picture(given)
  local w, h, colors = given.size[1], given.size[2], {}
  for i, color in ipairs(given.colors) do colors[i] = srgb(color) end
  local bars = {}
  for _, side in ipairs { -1, 1 } do
    bars[#bars + 1] = { shape = scene.box { size = { w + 0.05, 0.028, 0.03 }, radius = 0.006 },
      material = given.frame, position = { 0, side * (h / 2 + 0.011), 0 } }
    bars[#bars + 1] = { shape = scene.box { size = { 0.028, h + 0.05, 0.03 }, radius = 0.006 },
      material = given.frame, position = { side * (w / 2 + 0.011), 0, 0 } }
  end
  local mount = scene.material { name = "mount", color = srgb "#efe8d8", roughness = 0.9 }
  return {
    node { name = given.name .. "_frame", position = given.position, parts = bars },
    node { name = given.name .. "_mount", position = plus(given.position, { 0, 0, -0.004 }), material = mount,
      shape = scene.quad { size = { w, h } } },
    node { name = given.name, position = plus(given.position, { 0, 0, 0.001 }),
      shape = scene.quad { size = { w - 0.14, h - 0.14 } },
           material = scene.material { name = given.name, roughness = 0.8,
             color_texture = scene.texture.painting { size = { 512, 384 }, colors = colors, seed = given.seed } } },
  }
end

-- A few thin branches with berries, which grow from the point `given.position`. Returns a list of parts of one object, not
-- nodes.
function furniture.twigs(given)
  local random = studio.generator(given.seed)
  local bark = scene.material { name = "bark", color = srgb "#5b3d28", roughness = 0.9 }
  local berry = scene.material { name = "berry", color = srgb "#c63b2b", roughness = 0.35 }
  local parts = {}
  for i = 1, 5 do
    local angle = (i * 72 + 40 * random()) * math.pi / 180
    local lean, tall = 0.10 + 0.12 * random(), 0.34 + 0.16 * random()
    local x, z = math.cos(angle) * lean, math.sin(angle) * lean
    local function at(t) return plus(given.position, { x * t * t, tall * t, z * t * t + 0.012 * math.sin(7 * t + i) }) end
    parts[#parts + 1] = { material = bark, shape = scene.tube {
      path = { at(0), at(0.35), at(0.7), at(1) }, radii = { 0.0045, 0.004, 0.003, 0.0018 }, segments = 7, smooth = 5 } }
    for k = 1, 7 do
      local t = 0.42 + 0.58 * k / 7
      local point = at(t)
      local turn = random() * 6.283
      parts[#parts + 1] = { material = berry, shape = scene.sphere { radius = 0.006 + 0.003 * random(), segments = 10 },
                            position = { point[1] + 0.009 * math.cos(turn), point[2],
                              point[3] + 0.009 * math.sin(turn) } }
    end
  end
  return parts
end

return furniture
