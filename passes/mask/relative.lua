-- SPDX-License-Identifier: MIT
-- Pixels that hide something which the exposure uncovers, by the motion of foreground and background to each other.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

local motions = { doc = "two displacements per tile, px over the exposure; 1e9 = none" }

return pass.compute {
  name   = "mask_relative",
  shader = "mask/relative",
  doc    = "Pixels that leave their silhouette, relative to what is beyond it, within the exposure",
  fails  = "Background whose motion is visible nowhere near is not looked for. Blind to self-occlusion of one " ..
           "instance, to what comes into the picture from outside, and to the ninth and further movements near a " ..
           "tile.",
  size   = { of = "depth" },
  reads  = {
    depth     = { doc = "linear view depth, metres, sky = +inf" },
    id        = { uint = true, doc = "instance + 1; sky = 0" },
    velocity  = { doc = "px over the exposure" },
    motions_0 = motions, motions_1 = motions, motions_2 = motions, motions_3 = motions,
  },
  writes = { mask = { format = "r8_unorm", doc = "1 where something is to be revealed" } },
  without = { motion = { mask = 0 } },
  params = {
    tile   = blur.tile,
    limit  = blur.limit,
    match  = pass.float { 0.25, min = 0, max = 10,
      doc = "share of the relative motion by which a background may differ" },
    margin = pass.int { 1, min = 0, max = 64, unit = "px", doc = "how much farther than the relative motion to look" },
    occluder = pass.float { 0.02, min = 0, max = 1,
      doc = "what is nearer by more than this share of the depth stands in front and ends no silhouette" },
  },
  counters = { off_screen = "paths that left the picture, taken as uncovering nothing" },
}
