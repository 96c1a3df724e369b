-- SPDX-License-Identifier: MIT
-- Two rectangles that move in different directions before a static background, for 96 x 96 px. `a` is [a_left, a_left +
-- a_width) x [a_top, ...), moves by (a_x, a_y) px over the exposure, and is nearer than `b`.
local scene = require "strobe.scene"
local pixels = require "scripts.scenes.lib.pixels"

local picture = pixels.picture(96, 96)
local background = scene.param("background", 0.2)

local function rectangle(name, z, left, top, width, height, dx, dy, value)
  left, top = scene.param(name .. "_left", left), scene.param(name .. "_top", top)
  width, height = scene.param(name .. "_width", width), scene.param(name .. "_height", height)
  dx, dy = scene.param(name .. "_x", dx), scene.param(name .. "_y", dy)
  return pixels.rectangle(picture, name, { left, top, left + width, top + height }, z,
    pixels.flat(name, scene.param(name .. "_value", value)), pixels.motion(picture, dx, dy))
end

return pixels.scene(picture, "crossing", {
  pixels.rectangle(picture, "background", { -96, -96, 192, 192 }, -20, pixels.flat("background", background)),
  rectangle("b", -10, 32, 0, 32, 32, 0, 10, 0.6),
  rectangle("a", 0, 0, 0, 32, 32, 12, 0, 1),
})
