-- SPDX-License-Identifier: MIT
-- A crate leaves the picture at the right within the exposure. The exposure ends at the raster time, so the raster image does
-- not show the crate. A ball enters from the left; it is outside of the picture at shutter open. `pixels`: displacement of the
-- crate over the exposure, px. The displacement of the ball is larger by a tenth.
local scene = require "strobe.scene"
local studio = require "scripts.scenes.lib.studio"

local pixels = scene.param("pixels", 100)
local view = studio.open({ 0, 0.8, 4 }, { 0, 0.65, 0 }, 30)
local srgb = scene.srgb

local side, radius = 0.5, 0.36
local crate_z, ball_z = 0.2, -0.25
local function edge(z, pixel) return (pixel - view.width / 2) * view:metres_per_pixel { 0, 0.6, z } end

-- Centre of the crate at the raster time. All of the crate, with its far face, is then at least 12 px outside of the picture.
local crate_x = edge(crate_z - side / 2, view.width + 12) + side / 2
local crate_path = pixels * view:metres_per_pixel { 0, 0.6, crate_z }
local ball_path = 1.1 * pixels * view:metres_per_pixel { 0, 0.6, ball_z }
local ball_x = edge(ball_z, -16) - radius + ball_path

local slats = scene.material { name = "slats", roughness = 0.8, color_texture = scene.use {
  texture = scene.texture.wood { colors = { srgb "#d0a468", srgb "#5e3c20" }, count = 4, line = 0.16, seed = 3 } } }
local beach = scene.material { name = "beach ball", roughness = 0.5, color_texture = scene.texture.stripes {
  colors = { srgb "#f3ead6", srgb "#b8442f", srgb "#f3ead6", srgb "#27405e" }, count = 3 } }

return view:scene("enters", {
  studio.wall { name = "wall", position = { 0, 0.9, -1.2 }, size = { 5.6, 3 }, cell = 0.17, depth = 0.4, seed = 11 },
  studio.floor { size = { 8, 6 }, cell = 0.2 },
  scene.node { name = "crate", position = { crate_x, side / 2, crate_z }, material = slats,
    shape = scene.box { size = { side, side, side }, radius = 0.01 },
    motion = { velocity = view:velocity { crate_path } } },
  scene.node { name = "ball", position = { ball_x, radius + 0.25, ball_z }, material = beach, rotation = { 20, 0, 15 },
    shape = scene.sphere { radius = radius, segments = 48 },
    motion = { velocity = view:velocity { ball_path }, axis = { 0, 0, 1 }, degrees_per_second = -view:rate(20) } },
})
