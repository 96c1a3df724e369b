-- SPDX-License-Identifier: MIT
-- The camera pans to the right, by `pixels` px over the exposure, past posts and balls on a plain under a cloudy sky. The
-- clouds are a texture on a sphere with a radius of 400 m.
local scene = require "strobe.scene"
local studio = require "scripts.scenes.lib.studio"

local pixels = scene.param("pixels", 40)
local view = studio.open({ 0, 1.2, 6 }, { 0, 1.9, 0 }, 36)
local random = studio.generator(scene.param("seed", 6))

local clouds = scene.material { name = "clouds", unlit = true, color_texture = scene.use { scale = { 3, 2 },
  texture = scene.texture.noise { colors = { scene.srgb "#4f86c6", scene.srgb "#f4f6f8" }, count = 12, amount = 1, seed = 4 },
} }

local things = {}
for i = 0, 8 do
  local depth = 2.5 - 1.1 * i
  local x = (i * 0.618 % 1 - 0.5) * 0.9 * view:depth { 0, 1, depth } * view.width / view.focal_px
  local color = studio.colors[1 + i % #studio.colors]
  things[#things + 1] = scene.node { name = "thing_" .. i, material = studio.plain("thing " .. i, color),
    shape = i % 2 == 0 and scene.cylinder { radius = 0.06, height = 3.2, segments = 24 } or scene.sphere { radius = 0.5 },
    position = { x, i % 2 == 0 and 1.6 or 0.4 + 0.3 * random(), depth } }
end

return view:scene("panorama", {
  scene.node { name = "sky", shape = scene.sphere { radius = 400, segments = 96 }, material = clouds },
  studio.floor { name = "plain", size = { 600, 600 }, cell = 1.2, colors = { "#7d8060", "#5f6a4a" } },
  things,
}, { axis = { 0, 1, 0 }, degrees_per_second = -view:rate(math.deg(pixels / view.focal_px)) })
