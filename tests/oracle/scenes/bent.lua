-- SPDX-License-Identifier: MIT
-- A bright rectangle whose velocity changes at the raster time (frame 0) and may be accelerated, over a checker of 8
-- pixels that moves by `d_b` pixels over the exposure. At t exposures after the raster time the rectangle is displaced
-- by before * t for t < 0 and after * t for t > 0, plus `bend` * t^2 / 2 along x; pixels, x right, y down.
local scene = require "strobe.scene"
local pixels = require "scripts.scenes.lib.pixels"

local picture = pixels.picture(96, 32)
local left, right = scene.param("left", 30), scene.param("right", 62)
local top, bottom = scene.param("top", -8), scene.param("bottom", 40)
local before, after = scene.param("before", 20), scene.param("after", 20)
local before_y, after_y = scene.param("before_y", 0), scene.param("after_y", 0)
local bend, d_b = scene.param("bend", 0), scene.param("d_b", 0)
local light, dark = scene.param("light", 0.4), scene.param("dark", 0.1)

local bar = pixels.rectangle(picture, "bar", { left, top, right, bottom }, 0, pixels.flat("bar", 0.9))

-- Quadratic on either side of the raster time, so one cubic per side is exact.
local reach, exposure_s = 8, picture.exposure / picture.fps
local function place(t)
  local vx, vy = t < 0 and before or after, t < 0 and before_y or after_y
  local x, y, z = table.unpack(bar.position)
  return { x + vx * t + bend * t * t / 2, y - vy * t, z }
end
local function tangent(vx, vy, t) return { (vx + bend * t) / exposure_s, -vy / exposure_s, 0 } end

local motion = scene.animation {
  name = "bent",
  tracks = { scene.track {
    node = "bar", target = "translation", interpolation = "cubic",
    times = { -reach * exposure_s, 0, reach * exposure_s },
    values = {
      { 0, 0, 0 }, place(-reach), tangent(before, before_y, -reach),
      tangent(before, before_y, 0), place(0), tangent(after, after_y, 0),
      tangent(after, after_y, reach), place(reach), { 0, 0, 0 },
    },
  } },
}

local margin = 48 -- six cells: the corner of the checker is a light cell again
local function grey(value) return { value, value, value } end
local checker = scene.material {
  name = "checker", unlit = true,
  color_texture = scene.use {
    texture = scene.texture.texels {
      width = 2, height = 2, texels = { grey(light), grey(dark), grey(dark), grey(light) },
    },
    scale = { (picture.width + 2 * margin) / 16, (picture.height + 2 * margin) / 16 },
  },
}

return pixels.scene(picture, "bent", {
  pixels.rectangle(picture, "checker", { -margin, -margin, picture.width + margin, picture.height + margin }, -10,
    checker, pixels.motion(picture, d_b)),
  bar,
}, 0, { motion })
