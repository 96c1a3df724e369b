-- SPDX-License-Identifier: MIT
-- A ball drifts by `pixels` px over the exposure. Half a second after frame 0, the ball jumps to another place. `cut`:
-- true if the scene declares the jump as a cut, so that frames do not blur over the jump. At 24 frames per second,
-- frame 12 is the first frame after the jump.
local scene = require "strobe.scene"
local studio = require "scripts.scenes.lib.studio"

local pixels, cut = scene.param("pixels", 12), scene.param("cut", false)
local view = studio.open({ 0, 0.9, 4 }, { 0, 0.75, 0 }, 30)
local drift = pixels * view:metres_per_pixel { 0, 0.6, 0 }
local jump, moment = 0.5, 1e-4

local function at(x) return { x, 0.55, 0 } end
local from, to = -1.1, 0.7

local beach = scene.material { name = "beach ball", roughness = 0.5, color_texture = scene.texture.stripes {
  colors = { scene.srgb "#f3ead6", scene.srgb "#b8442f", scene.srgb "#f3ead6", scene.srgb "#27405e" }, count = 3 } }

return view:scene("jump", {
  studio.wall { name = "wall", position = { 0, 0.9, -1.2 }, size = { 5.6, 3 }, cell = 0.17, depth = 0.4, seed = 11 },
  studio.floor { size = { 8, 6 }, cell = 0.2 },
  scene.node { name = "ball", position = at(to), material = beach, rotation = { 20, 0, 15 }, cuts = cut and { jump } or nil,
    shape = scene.sphere { radius = 0.33, segments = 48 } },
}, nil, {
  scene.animation { name = "drift", tracks = {
    scene.track { node = "ball", times = { 0, jump - moment, jump, 1 },
      values = { at(from - view:rate(drift) * jump), at(from), at(to), at(to + view:rate(drift) * jump) } } } },
})
