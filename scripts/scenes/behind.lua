-- SPDX-License-Identifier: MIT
-- Test scene for rays that pass through a moving object to the background behind it. A closed object slides past panels by
-- `speed` px over the exposure. A ray through the object hits its parts and its far side before it hits the background. A
-- rule that ends the ray by luminance, geometry or instance may stop at the wrong hit. All materials are unlit, so the
-- colours determine the luminances. Parameters:
-- cell    side of the cells of the background, px
-- behind  the background:
--         varied    a wall of cells of different luminances
--         alike     the same wall, with a panel between it and the object. The cells of the panel have other colours than the
--                   box of `front` = plain, but the same luminance
-- front   the object:
--         plain     a box of one colour
--         textured  the same box, checkered: its far side is as bright as its near side at half of the pixels
--         parts     a box inside a box. The two boxes are parts of one object and have different luminances
--         alike     as `parts`, but the two boxes have the same luminance
--         nodes     as `parts`, but each box is an object of its own; both objects have the same motion
--         posts     a rotating ring of posts, one object: far posts move in the opposite direction of near posts
local scene = require "strobe.scene"
local stage = require("scripts.scenes.lib.stage").open()

local front, behind = scene.param("front", "plain"), scene.param("behind", "varied")
local speed, cell = scene.param("speed", 24), scene.param("cell", 9)
local depth, thickness = 10, 2
local w, h = stage.width, stage.height

-- ---- colours

-- Returns `color`, scaled so that its luminance is `luminance`.
local function as_bright(color, luminance)
  local factor = luminance / (0.2126 * color[1] + 0.7152 * color[2] + 0.0722 * color[3])
  return { factor * color[1], factor * color[2], factor * color[3] }
end

local orange, blue = as_bright({ 1, 0.3, 0.05 }, 0.25), as_bright({ 0.2, 0.45, 1 }, 0.25)
local alike = { blue, as_bright({ 0.1, 1, 0.3 }, 0.25), as_bright({ 0.9, 0.4, 0.9 }, 0.25) }

local function flat(name, color) return scene.material { name = name, color = color, unlit = true } end

-- ---- moving object

-- A box. Its width and height are in pixels, measured at its near side.
local function box(pixels_wide, pixels_high, deep)
  local metre = stage:point(w / 2 + 1, h / 2, depth)[1]
  return scene.box { size = { pixels_wide * metre, pixels_high * metre, deep * stage.scale } }
end

local outer, inner = box(0.26 * w // 1, 0.4 * h // 1, thickness), box(0.2 * w // 1, 0.3 * h // 1, thickness / 2)
local middle = stage:placed(stage:point(w / 2, h / 2, depth + thickness / 2))
local sliding = { velocity = stage:velocity(speed, 0, depth) }

local function object(name, fields)
  fields.name, fields.position, fields.motion = name, middle, fields.motion or sliding
  return scene.node(fields)
end

local function with_core(luminance)
  return { { shape = outer, material = flat("shell", orange) },
           { shape = inner, material = flat("core", as_bright(blue, luminance)) } }
end

local fronts = {}

function fronts.plain() return { object("box", { shape = outer, material = flat("shell", orange) }) } end

function fronts.textured()
  local checker = scene.texture.checker { size = { 64, 64 }, colors = { orange, as_bright(blue, 0.1) }, count = 6 }
  return { object("box", { shape = outer,
    material = scene.material { name = "shell", color_texture = checker, unlit = true } }) }
end

function fronts.parts() return { object("box", { parts = with_core(0.08) }) } end

function fronts.alike() return { object("box", { parts = with_core(0.25) }) } end

function fronts.nodes()
  local nodes = {}
  for i, part in ipairs(with_core(0.08)) do nodes[i] = object("box_" .. i, part) end
  return nodes
end

function fronts.posts()
  local radius, count, parts = 3 * stage.scale, 10, {}
  for i = 1, count do
    local angle = 2 * math.pi * (i + 0.25) / count
    parts[i] = {
      shape = box(12, 0.5 * h // 1, 0.6), position = { radius * math.sin(angle), 0, radius * math.cos(angle) },
      rotation = { 0, math.deg(angle), 0 },
      material = flat("post_" .. i % 3, ({ orange, alike[1], as_bright(orange, 0.1) })[1 + i % 3]),
    }
  end
  -- The near side of the object moves by `speed` px over the exposure.
  local near = (depth + thickness / 2) * stage.scale - radius
  local degrees = math.deg(speed * near / stage.focal_px / radius)
  return { object("posts", { parts = parts,
    motion = { axis = { 0, 1, 0 }, degrees_per_second = degrees * stage.fps / stage.exposure } }) }
end

-- ---- background

local function wall(name, colors, at, seed)
  return stage:panel { name = name, edges = { -8, -8, w + 8, h + 8 }, cell = cell, seed = seed, colors = colors, depth = at }
end

local function choice(list, name, what)
  return list[name] or error(("behind: there is no %s '%s'"):format(what, tostring(name)), 0)
end

local nodes = choice(fronts, front, "front")()
nodes[#nodes + 1] = wall("wall", stage.cold, 30, 1)
if behind == "alike" then nodes[#nodes + 1] = wall("panel", alike, 16, 2) end

return stage:scene("behind", nodes, depth / 10)
