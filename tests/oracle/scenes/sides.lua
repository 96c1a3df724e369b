-- SPDX-License-Identifier: MIT
-- Cards of brightness 0.9 in squares of 8 x 8 px, side by side, before a wall of 0.2. All but two are one-sided. From
-- the left: facing the camera; facing away; facing away, double-sided; mirrored in x; mirrored in z, which turns its
-- front away; and one object of three cards: facing the camera, facing away, facing away and double-sided.
local scene = require "strobe.scene"
local pixels = require "scripts.scenes.lib.pixels"

local picture = pixels.picture(64, 8)

local function paper(double_sided)
  return scene.material { name = "paper", color = { 0.9, 0.9, 0.9 }, unlit = true, double_sided = double_sided }
end

local function card(column, fields)
  fields.name = "card " .. column
  fields.position = { 8 * column - 4 - picture.width / 2, 0, 0 }
  fields.shape = scene.quad { size = { 8, 8 } }
  fields.material = fields.material or paper(false)
  return scene.node(fields)
end

local function part(column, away, double_sided)
  return {
    shape = scene.quad { size = { 8, 8 } }, material = paper(double_sided), position = { 8 * (column - 1), 0, 0 },
    rotation = { 0, away and 180 or 0, 0 },
  }
end

local wall = pixels.flat("wall", 0.2)
return pixels.scene(picture, "sides", {
  pixels.rectangle(picture, "wall", { -8, -8, picture.width + 8, picture.height + 8 }, -10, wall),
  card(1, {}),
  card(2, { rotation = { 0, 180, 0 } }),
  card(3, { rotation = { 0, 180, 0 }, material = paper(true) }),
  card(4, { scale = { -1, 1, 1 } }),
  card(5, { scale = { 1, 1, -1 } }),
  scene.node {
    name = "three", position = { 8 * 6 - 4 - picture.width / 2, 0, 0 },
    parts = { part(1, false, false), part(2, true, false), part(3, true, true) },
  },
})
