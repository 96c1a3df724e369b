-- SPDX-License-Identifier: MIT
-- A wedge turns about its tip, at the centre of the picture, by `degrees` anticlockwise over the exposure. The background has a
-- constant colour. docs/derivations.md has the exact picture. At frame 0, the wedge covers the directions from `from` to `to`
-- degrees (anticlockwise from +x, y up), and it extends beyond the picture. Further parameters:
-- blades      number of wedges, spaced evenly around the tip
-- slide       motion of the wedges to the left, px over the exposure; points then follow cycloids, as on a rolling wheel
-- slides_off  motion of two cards to the right, px over the exposure; the cards have the colour of the background and cover the
--             right half of the picture at frame 0; 0: no cards
local scene = require "strobe.scene"
local pixels = require "scripts.scenes.lib.pixels"

local picture = pixels.picture(128, 128)
local from, to = scene.param("from", 20), scene.param("to", 65)
local degrees = scene.param("degrees", 30)
local blades, slide = scene.param("blades", 1), scene.param("slide", 0)
local slides_off = scene.param("slides_off", 0)
local foreground = scene.param("foreground", 1)
local background = scene.param("background", 0)

-- The round side of the wedge lies outside of the picture. It is a polygon with a corner every 15 degrees or less.
local radius = picture.width + picture.height
local steps = math.max(1, math.ceil((to - from) / 15))
local function rim(blade, step)
  local angle = math.rad(from + 360 * blade / blades + (to - from) * step / steps)
  return { radius * math.cos(angle), radius * math.sin(angle), 0 }
end
local positions = {}
for blade = 0, blades - 1 do
  for step = 0, steps - 1 do
    for _, corner in ipairs { { 0, 0, 0 }, rim(blade, step), rim(blade, step + 1) } do positions[#positions + 1] = corner end
  end
end

local nodes = {
  pixels.rectangle(picture, "background", { -8, -8, picture.width + 8, picture.height + 8 }, -10,
    pixels.flat("background", background)),
  scene.node {
    name = "wedge", shape = scene.triangles { positions = positions }, material = pixels.flat("wedge", foreground),
    motion = {
      axis = { 0, 0, 1 }, degrees_per_second = degrees * picture.fps / picture.exposure,
      velocity = { -slide * picture.fps / picture.exposure, 0, 0 },
    },
  },
}
for number = 1, slides_off > 0 and 2 or 0 do
  nodes[#nodes + 1] = pixels.rectangle(picture, "card_" .. number,
    { picture.width / 2, -8, 2 * picture.width, picture.height + 8 }, 10 * number, pixels.flat("card", background),
    pixels.motion(picture, slides_off))
end
return pixels.scene(picture, "wedge", nodes)
