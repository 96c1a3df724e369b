-- SPDX-License-Identifier: MIT
-- A hollow vase slides by `pixels` px over the exposure past a striped cushion on a bench, in low sun. The scene has the
-- situation of figure 1 of Tan, Cui and Bhojan 2020, with fewer objects than the living room. `vase`: "plain" (one colour) or
-- "patterned". `hollow`: 0 for a solid vase, otherwise the vase is hollow.
local scene = require "strobe.scene"

local texture, material, node, srgb = scene.texture, scene.material, scene.node, scene.srgb

local width, height = scene.param("width", 320), scene.param("height", 180)
local fps, exposure = scene.param("fps", 24), scene.param("exposure", 0.5)
local pixels = scene.param("pixels", 24)
local plain, hollow = scene.param("vase", "plain") == "plain", scene.param("hollow", 1) ~= 0

local fov, eye, aim = 30, { 0.1, 0.75, 2 }, { 0.05, 0.5, 0 }
local at = { -0.02, 0.3, 0.4 }
local distance = math.sqrt((aim[1] - eye[1]) ^ 2 + (aim[2] - eye[2]) ^ 2 + (aim[3] - eye[3]) ^ 2)
local depth = 0
for i = 1, 3 do depth = depth + (aim[i] - eye[i]) / distance * (at[i] + (i == 2 and 0.2 or 0) - eye[i]) end
local metres_per_pixel = 2 * math.tan(math.rad(fov / 2)) * depth / height

local outside = { { 0, 0 }, { 0.055, 0 }, { 0.085, 0.06 }, { 0.108, 0.14 }, { 0.106, 0.22 }, { 0.078, 0.29 },
                  { 0.046, 0.335 }, { 0.042, 0.40 }, { 0.056, 0.418 } }
local inside = { { 0.052, 0.421 }, { 0.036, 0.40 }, { 0.040, 0.335 }, { 0.070, 0.29 }, { 0.096, 0.20 }, { 0.06, 0.03 },
                 { 0, 0.02 } }
local profile = table.move(outside, 1, #outside, 1, {})
if hollow then table.move(inside, 1, #inside, #profile + 1, profile)
else profile[#profile + 1] = { 0, 0.418 } end

local glaze = plain and material { name = "glaze", color = srgb "#b8c4c8", roughness = 0.6 } or material {
  name = "glaze", roughness = 0.6,
  color_texture = texture.quilt { colors = { srgb "#14707a", srgb "#eadfc4", srgb "#d9a24a" }, count = { 8, 4 },
    line = 0.1 },
}
local striped = material {
  name = "cushion", roughness = 0.9,
  color_texture = texture.stripes {
    colors = { srgb "#f3ead6", srgb "#1d2f52", srgb "#f3ead6", srgb "#b8442f" }, widths = { 3, 3, 3, 1.5 }, count = 4,
  },
}

return scene {
  name = "vase_and_cushion",
  nodes = {
    node { name = "wall", shape = scene.quad { size = { 6, 4 } }, position = { 0, 1, -0.6 },
      material = material { name = "wall", color = srgb "#7f9487", roughness = 0.95 } },
    node { name = "bench", shape = scene.box { size = { 4, 0.3, 1.6 } }, position = { 0, 0.15, 0 },
      material = material { name = "bench", color = srgb "#6b4226", roughness = 0.6 } },
    node { name = "cushion", shape = scene.cushion { size = { 0.6, 0.5, 0.19 }, segments = 40 },
      position = { 0.22, 0.53, -0.3 }, rotation = { -12, -4, 2 }, material = striped },
    node { name = "vase", shape = scene.lathe { profile = profile, segments = 56, smooth = 5, crease = 50 },
      position = at, material = glaze, motion = { velocity = { pixels * metres_per_pixel * fps / exposure, 0, 0 } } },
    node { name = "sun", rotation = { -35, -50, 0 },
      light = scene.directional_light { color = srgb "#ffd29a", intensity = 4 } },
    node { name = "camera", position = eye, look_at = aim,
      camera = scene.camera { name = "main", fov = fov, near = 0.05 } },
  },
  environment = { sky = { 0.42, 0.45, 0.5 }, ground = { 0.3, 0.25, 0.2 } },
  shot = { width = width, height = height, fps = fps, frame = 0, exposure = exposure },
}
