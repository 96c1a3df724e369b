-- SPDX-License-Identifier: MIT
-- Test scene for surfaces at grazing angles: a tilted panel in the left half of the picture, in front of a wall. `tilt`: angle
-- between the panel's normal and the view direction, degrees. The left edge of a tilted panel is nearer to the camera than its
-- right edge; at 89.9 degrees, the right edge is up to 430 times as far away. The panel turns about the eye by `speed` px over
-- the exposure, measured in the middle of the picture. A rotation about the eye moves points of all depths alike in the
-- picture, so the correct picture does not depend on `tilt`.
local scene = require "strobe.scene"
local stage = require("scripts.scenes.lib.stage").open()

local speed, tilt = scene.param("speed", 12.8), math.rad(scene.param("tilt", 0))
local far = 10 -- depth of the right edge, metres

local w, h = stage.width, stage.height
local function depth(x) return far / (1 + (w / 2 - x) / stage.focal_px * math.tan(tilt)) end

return stage:scene("grazing", {
  stage:panel { name = "wall", edges = { -8, -8, w + 8, h + 8 }, cell = 9, seed = 1, colors = stage.cold,
    depth = far * 1.5 },
  stage:panel { name = "panel", edges = { w * 0.15 // 1, h * 0.3 // 1, w * 0.45 // 1, h * 0.7 // 1 }, cell = 12, seed = 2,
    colors = stage.warm, slant = 0.17, depth = depth,
    motion = { axis = { 0, -1, 0 },
      degrees_per_second = math.deg(speed / stage.focal_px) * stage.fps / stage.exposure } },
}, far / 1000)
