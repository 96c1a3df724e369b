-- SPDX-License-Identifier: MIT
-- Pixels that hide something which the exposure uncovers, by the motion of foreground and background to each other.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"
local path = require "passes.lib.relative_path"
local reach = require "passes.lib.reach"

local crossing = { doc = "two displacements per cell that something may be uncovered by; 1e9 = none" }

return pass.compute {
  name   = "mask_relative",
  shader = "mask/relative",
  doc    = "Pixels that leave their silhouette, relative to what is beyond it, within the exposure",
  fails  = "Background whose motion is visible nowhere near is not looked for. Blind to self-occlusion of one " ..
           "instance, to what comes into the picture from outside, to the ninth and further movements near a tile, and " ..
           "to what moves behind a surface at rest if all that is seen of it is in front of that.",
  size   = { of = "depth" },
  reads  = {
    depth     = { doc = "linear view depth, metres, sky = +inf" },
    id        = { uint = true, doc = "instance + 1; sky = 0" },
    velocity  = { doc = "px over the exposure" },
    bounds    = { doc = "of the displacements of each cell, px over the exposure" },
    ids       = { uint = true, doc = "least and greatest instance + 1 of each cell" },
    crossing_0 = crossing, crossing_1 = crossing, crossing_2 = crossing, crossing_3 = crossing,
    farthest_around = { doc = "depth of the farthest that moves around each tile, metres; 0 = none" },
    reach = reach,
  },
  writes = { mask = { format = "r8_unorm", doc = "1 where something is to be revealed" } },
  without = { motion = { mask = 0 }, reached = { mask = 0 } },
  params = {
    cell_side = blur.cell_side,
    tile      = blur.tile,
    limit     = blur.limit,
    match     = path.match,
    margin    = path.margin,
    occluder  = pass.float { 0.02, min = 0, max = 1,
      doc = "what is nearer by more than this share of the depth stands in front and ends no silhouette" },
  },
  counters = { off_screen = "paths that left the picture, taken as uncovering nothing" },
}
