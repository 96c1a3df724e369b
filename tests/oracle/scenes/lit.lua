-- SPDX-License-Identifier: MIT
-- A plane through (0, 0, -5) with one material, turned by `tilt_x` and then `tilt_y` degrees, under one light at
-- (`light_x`, `light_y`, `light_z`) that faces the plane's middle. `light`: 0 dark, 1 directional, 2 point, 3 spot.
-- `card` > 0: a card with that side length casts a shadow, `card_z` from the camera. The camera is at the origin and
-- looks along -z.
-- `metal`, `rough`, `glow` > -1, and `bump_x`, `bump_y`, `bump_z` (normal): constant textures of that value. `stripes`
-- > 0: number of black and white stripes per metre, of `texels` each, across the plane's x, or across its y if `along`
-- = 1. The plane consists of `segments` by `segments` squares.
local scene = require "strobe.scene"

local function number(name, default) return scene.param(name, default) end
for _, side in ipairs { "width", "height" } do number(side, 16) end -- given to every scene, but not used here
local light, intensity = number("light", 1), number("intensity", 3)
local metallic, roughness = number("metallic", 0), number("roughness", 0.5)
local metal, rough, glow = number("metal", -1), number("rough", -1), number("glow", -1)
local bump_x, bump_y, bump_z, bump = number("bump_x", 0), number("bump_y", 0), number("bump_z", 1), number("bump", 1)
local stripes, texels, along = number("stripes", 0), number("texels", 8), number("along", 0)
local card, card_z = number("card", 0), number("card_z", 3)
local segments = number("segments", 1)
local sky, ground = number("sky", 0), number("ground", 0)
local range, inner, outer = number("range", 0), number("inner", 10), number("outer", 25)
local light_x, light_y, light_z = number("light_x", 1), number("light_y", 2), number("light_z", -1)
local card_x, card_y = number("card_x", 0.5), number("card_y", 1)

local function constant(r, g, b)
  return scene.use { texture = scene.texture.texels { width = 1, height = 1, texels = { { r, g, b } } } }
end

local material = { name = "plane", color = { 0.8, 0.5, 0.2 }, metallic = metallic, roughness = roughness, normal_scale = bump }
if metal >= 0 then material.metallic_roughness_texture = constant(0, rough, metal) end
if bump_x ~= 0 or bump_y ~= 0 or bump_z ~= 1 then
  material.normal_texture = constant(0.5 + bump_x / 2, 0.5 + bump_y / 2, 0.5 + bump_z / 2)
end
if glow >= 0 then
  material.emissive = { 0.5, 1, 2 }
  material.emissive_texture = constant(glow, glow, glow)
end
local extent = 40
if stripes > 0 then
  material.color, material.unlit = { 1, 1, 1 }, true
  material.color_texture = scene.use {
    texture = scene.texture.stripes { size = { 2 * texels, 2 * texels }, count = 1, colors = { { 0, 0, 0 }, { 1, 1, 1 } } },
    scale = { extent * stripes / 2, extent * stripes / 2 }, rotation = along * 90,
  }
end

local nodes = {
  scene.node {
    name = "plane", position = { 0, 0, -5 }, rotation = { number("tilt_x", 0), number("tilt_y", 0), 0 },
    shape = scene.quad { size = { extent, extent }, segments = segments }, material = scene.material(material),
  },
  scene.node {
    name = "camera", camera = scene.camera { name = "main", fov = 60, near = 0.1 },
  },
}
do
  -- Intensity 0 stands for no light: a scene without a light would get a default one.
  local fields = { name = "light", intensity = light > 0 and intensity or 0, color = { 1, 0.9, 0.7 }, shadow = card > 0 }
  if light > 1 then fields.range = range end
  if light == 3 then fields.inner_cone, fields.outer_cone = inner, outer end
  local made = ({ scene.directional_light, scene.point_light, scene.spot_light })[math.max(light, 1)](fields)
  nodes[#nodes + 1] = scene.node {
    name = "light", position = { light_x, light_y, light_z },
    look_at = { 0, 0, -5 }, light = made,
  }
end
if card > 0 then
  nodes[#nodes + 1] = scene.node {
    name = "card", position = { card_x, card_y, -card_z },
    shape = scene.quad { size = { card, card } },
    material = scene.material { name = "card", color = { 0, 0, 0 }, unlit = true },
  }
end

return scene {
  name = "lit", nodes = nodes,
  environment = { sky = { sky, sky, sky }, ground = { ground, ground / 2, ground }, background = { 0.5, 0.5, 0.5 } },
}
