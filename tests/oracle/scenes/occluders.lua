-- SPDX-License-Identifier: MIT
-- Random objects, by `seed`, between lights and lit surfaces: large and small, thin, flattened, mirrored, cut out,
-- around a light, with a light on their surface. For light visibility of tiles, computed without tracing shadow rays.
local scene = require "strobe.scene"
local param = scene.param
local seed, count, scale = param("seed", 1), param("count", 40), param("scale", 1)
local orthographic, width, height = param("orthographic", 0), param("width", 160), param("height", 90)

local drawn = 0
-- Next number of a sequence in 0..1.
local function random()
  drawn = drawn + 1
  local state = math.tointeger(seed) * 0x9E3779B97F4A7C15 + drawn * 0xD1B54A32D192ED03
  state = (state ~ (state >> 32)) * 0xD6E8FEB86659FD93
  state = (state ~ (state >> 32)) * 0xD6E8FEB86659FD93
  return ((state ~ (state >> 32)) >> 11 & 0xFFFFFFFFFFFFF) / 2 ^ 52
end
local function between(low, high) return low + (high - low) * random() end
local function log_between(low, high) return low * (high / low) ^ random() end
local function pick(list) return list[1 + math.floor(random() * #list)] end
local function point(reach) return { between(-reach, reach), between(-reach, reach), between(-reach, reach) } end
local function sized(p) return { p[1] * scale, p[2] * scale, p[3] * scale } end
local function turned() return { between(0, 360), between(0, 360), between(0, 360) } end

local solid = scene.material { name = "solid", color = { 0.7, 0.7, 0.7 } }
local one_sided = scene.material { name = "one_sided", color = { 0.8, 0.5, 0.4 }, double_sided = false }
local there, hole = { 0.4, 0.6, 0.8, 1 }, { 0.4, 0.6, 0.8, 0 }
local cut_out = scene.material { name = "cut_out", alpha_cutoff = 0.5,
  color_texture = scene.texture.texels { width = 4, height = 2,
                                         texels = { there, hole, there, hole, hole, there, hole, there } } }

local function soup()
  local positions = {}
  for _ = 1, 30 do
    local at, size = point(1), log_between(0.01, 2)
    for _ = 1, 3 do
      local p = point(size)
      positions[#positions + 1] = { at[1] + p[1], at[2] + p[2], at[3] + p[3] }
    end
  end
  return scene.triangles { positions = positions }
end
local function shape()
  local kind = pick { "quad", "box", "sphere", "cylinder", "soup", "torus" }
  local size = log_between(0.02, 1.5)
  if kind == "quad" then return scene.quad { size = { size, log_between(0.02, 2) } } end
  if kind == "box" then return scene.box { size = { size, log_between(0.02, 1), log_between(0.001, 1) } } end
  if kind == "sphere" then return scene.sphere { radius = 0.5 * size, segments = math.floor(between(4, 40)) } end
  if kind == "torus" then return scene.torus { radius = 0.5 * size, tube_radius = 0.1 * size } end
  if kind == "cylinder" then
    return scene.cylinder { radius = 0.4 * size, top_radius = 0.2 * size, height = size,
                            segments = math.floor(between(3, 64)) }
  end
  return soup()
end
local function scales()
  local s = scale * log_between(0.3, 2)
  local way = random()
  if way < 0.6 then return { s, s, s } end
  if way < 0.8 then return { s * log_between(0.01, 3), s, -s } end
  if way < 0.95 then return { s, s * 1e-3, s } end
  return { s, s, 0 }
end

local nodes = {}
local function add(node)
  node.name = "n" .. #nodes
  nodes[#nodes + 1] = scene.node(node)
end
local walls = { { { 0, -3, 0 }, { -90, 0, 0 } }, { { 0, 0, -4 }, { 0, 0, 0 } }, { { -4, 0, 0 }, { 0, 90, 0 } } }
for _, wall in ipairs(walls) do
  if random() < 0.8 then
    add { shape = scene.quad { size = { 12, 12 }, segments = math.floor(between(1, 9)) }, material = solid,
          position = sized(wall[1]), rotation = wall[2], scale = { scale, scale, scale } }
  end
end
for _ = 1, count do
  add { shape = shape(), material = pick { solid, solid, one_sided, cut_out }, position = sized(point(3)),
        rotation = random() < 0.4 and { 0, 0, 0 } or turned(), scale = scales() }
end
for _ = 1, math.floor(between(2, 7)) do
  local at = point(3.5)
  local color, way = { between(0.3, 1), between(0.3, 1), between(0.3, 1) }, random()
  local light
  local strength = between(2, 12) * scale * scale
  if way < 0.25 then
    light = scene.directional_light { color = color, intensity = 1 }
  elseif way < 0.85 then
    light = scene.point_light { color = color, intensity = strength, range = random() < 0.2 and 4 * scale or 0 }
  else
    light = scene.spot_light { color = color, intensity = 3 * strength, inner_cone = 20, outer_cone = between(25, 80) }
  end
  add { light = light, position = sized(at), rotation = random() < 0.2 and { -90, 0, 0 } or turned() }
  if random() < 0.5 then
    add { shape = pick { scene.cylinder { radius = 0.2, top_radius = 0.1, height = 0.3, segments = 24 },
                         scene.sphere { radius = 0.15, segments = 12 }, scene.quad { size = { 0.5, 0.5 } } },
          material = pick { solid, one_sided, cut_out }, position = sized(at), scale = { scale, scale, scale },
          rotation = random() < 0.5 and { 0, 0, 0 } or turned() }
  end
end
local eye = sized { between(-2, 2), between(0, 2), 5 }
local camera = orthographic ~= 0 and scene.orthographic_camera { half_height = 3 * scale, near = 0.01 * scale }
  or scene.camera { fov = between(30, 80), near = 0.01 * scale }
nodes[#nodes + 1] = scene.node { name = "eye", position = eye, look_at = { 0, 0, 0 }, camera = camera }

return scene {
  name = "occluders", nodes = nodes, environment = { sky = { 0.1, 0.1, 0.12 } },
  shot = { width = width, height = height, frame = 0 },
}
