-- SPDX-License-Identifier: MIT
-- Test scene for numerical extremes: a lit, textured room, which can be moved, scaled and sped up with known effects on
-- the picture. A card moves to the right and down, a ball turns in front of a wall, and a floor extends into the
-- distance. The camera is a pinhole with a focal length of 64 px, so one pixel spans z / 64 at the depth z. Parameters:
-- scale     factor on all lengths, and on lights, so that the picture stays the same
-- offset    translation of the whole scene, with the camera, along (1, 0.3, -0.7), metres
-- nesting   0: each node has the offset; 1: one parent node has the offset; 2: a parent node has the offset and each node
--           reverses it, so that the scene is at the origin; 3: as 0, but the vertices of the card's mesh have the offset
-- speed     factor on the speed of card and ball
-- camera_speed  motion of the camera to the left, px over the exposure at a depth of 16
-- turn      rotation of the camera to the left, degrees over the exposure
-- rest_s    scene time when the objects have the poses given in this file, seconds
local scene = require "strobe.scene"

local param = scene.param
local width, height = param("width", 48), param("height", 32)
local scale, offset, nesting = param("scale", 1), param("offset", 0), param("nesting", 0)
local speed, camera_speed, turn = param("speed", 1), param("camera_speed", 0), param("turn", 0)
local rest_s, brightness, near = param("rest_s", 0), param("brightness", 1), param("near", 0.5)
local exposures_per_second = 24 / 0.5

local function world(p) return { p[1] + offset, p[2] + 0.3 * offset, p[3] - 0.7 * offset } end
local function scaled(p) return { p[1] * scale, p[2] * scale, p[3] * scale } end

-- Returns a node at the position `p` (before scaling), far from the origin by the scene's parameter `offset`. The parameter
-- `nesting` decides whether the node or its parents have this offset.
local function placed(p, fields)
  p = scaled(p)
  if nesting == 0 or nesting == 3 then
    fields.position = world(p)
  elseif nesting == 1 then
    fields.position = p
  else
    fields.position = { p[1] - offset, p[2] - 0.3 * offset, p[3] + 0.7 * offset }
  end
  if fields.motion then fields.motion.rest_time = rest_s end
  return scene.node(fields)
end

local function rate(px, depth) return px * depth / 64 * scale * exposures_per_second end

local function plain(name, color) return scene.material { name = name, color = color, roughness = 0.6 } end

local checker = scene.material {
  name = "checker", roughness = 0.8, color_texture = scene.use {
    texture = scene.texture.checker { size = { 64, 64 }, colors = { { 0.7, 0.6, 0.3 }, { 0.2, 0.25, 0.4 } }, count = 8 },
    scale = { 2, 2 },
  },
}

local card_at = { -1.3, 0.6, -12 }
local card = { name = "card", material = plain("card", { 0.9, 0.2, 0.1 }) }
card.motion = { velocity = { rate(6.4375, 12) * speed, -rate(3.3125, 12) * speed, 0 } }
if nesting == 3 then
  local c, w, h = world(scaled(card_at)), 1.55 * scale, 1.05 * scale
  card.shape = scene.triangles {
    positions = { { c[1] - w, c[2] - h, c[3] }, { c[1] + w, c[2] - h, c[3] }, { c[1] + w, c[2] + h, c[3] },
                  { c[1] - w, c[2] + h, c[3] } },
    indices = { 1, 2, 3, 1, 3, 4 },
  }
else
  card.shape = scene.quad { size = { 3.1 * scale, 2.1 * scale } }
end
local card_node = placed(card_at, card)
if nesting == 3 then card_node.position = { 0, 0, 0 } end

local nodes = {
  placed({ 0.5, 0.7, -20 }, { name = "wall", shape = scene.quad { size = { 40 * scale, 24 * scale } }, material = checker }),
  placed({ 0, -3.1, -14 }, { name = "floor", rotation = { -90, 0, 0 },
    shape = scene.quad { size = { 40 * scale, 26 * scale } }, material = plain("floor", { 0.3, 0.5, 0.3 }) }),
  placed({ 2.7, -0.9, -15 }, { name = "ball", shape = scene.sphere { radius = 1.4 * scale, segments = 24 },
    material = plain("ball", { 0.2, 0.3, 0.8 }),
    motion = { axis = { 0, 0, 1 }, degrees_per_second = 20 * exposures_per_second * speed } }),
  card_node,
  placed({ -2, 4, -8 }, { name = "lamp",
    light = scene.point_light { intensity = 260 * scale * scale * brightness, color = { 1, 0.95, 0.9 } } }),
  placed({ 0, 0, 0 }, { name = "camera",
    motion = { velocity = { -rate(camera_speed, 16), 0, 0 }, axis = { 0, 1, 0 },
      degrees_per_second = turn * exposures_per_second },
    camera = scene.camera { name = "main", fov = math.deg(2 * math.atan(height / 2 / 64)), near = near * scale } }),
}

if nesting == 1 then
  nodes = { scene.node { name = "world", position = world { 0, 0, 0 }, children = nodes } }
elseif nesting == 2 then
  nodes = { scene.node { name = "there", position = world { 0, 0, 0 }, children = nodes } }
end

return scene {
  name = "extreme", nodes = nodes,
  environment = { sky = { 0.2, 0.25, 0.3 }, ground = { 0.1, 0.1, 0.1 }, background = { 0.25, 0.5, 1 } },
  shot = { width = width, height = height, fps = 24, frame = 0, exposure = 0.5 },
}
