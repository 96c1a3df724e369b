-- SPDX-License-Identifier: MIT
-- A panel of cells in warm colours moves in front of a wall of cells in cold colours, parallel to the image plane. It moves by
-- `speed` px over the exposure in the direction `angle` (degrees anticlockwise from +x). The sides of the panel are slanted.
-- The depth of the wall is 1 + `gap` times the depth of the panel. The wall looks the same at any depth, so the correct picture
-- does not depend on `gap`.
local scene = require "strobe.scene"
local stage = require("scripts.scenes.lib.stage").open()

local speed, angle = scene.param("speed", 12.8), math.rad(scene.param("angle", 0))
local gap = scene.param("gap", 0.5)
local front = 10 -- depth of the panel, metres

local w, h = stage.width, stage.height
local middle = stage:point(w / 2, h / 2, front)
return stage:scene("passage", {
  stage:panel { name = "wall", edges = { -8, -8, w + 8, h + 8 }, cell = 9, seed = 1, colors = stage.cold,
    depth = front * (1 + gap) },
  stage:panel { name = "panel", edges = { w * 0.35 // 1, h * 0.3 // 1, w * 0.65 // 1, h * 0.7 // 1 }, cell = 12,
    seed = 2, colors = stage.warm, slant = 0.17, depth = front, at = middle,
    motion = { velocity = stage:velocity(speed * math.cos(angle), -speed * math.sin(angle), front) } },
}, front / 10)
