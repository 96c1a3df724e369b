-- SPDX-License-Identifier: MIT
-- Pixels whose background is disoccluded within the exposure, by the relative motion of foreground and background.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"
local path = require "passes.lib.relative_path"
local max_displacement = require "passes.lib.max_displacement"

local culled = { doc = "two candidate background displacements per cell, px over the exposure; 1e9 for none" }

return pass.compute {
  doc    = "Pixels whose background is disoccluded within the exposure, by the relative motion of foreground and background",
  fails  = "Misses background whose motion is not visible near the pixel, self-occlusion of one instance, surfaces that " ..
           "enter the image from outside, and motions near a tile beyond the first eight. Misses objects that move behind a " ..
           "static surface if all their visible parts are in front of it.",
  size   = { of = "depth" },
  reads  = {
    depth     = { doc = "linear view depth, metres; +inf for the sky" },
    id        = { uint = true, doc = "instance + 1; 0 for the sky" },
    velocity  = { doc = "displacement of the surface, px over the exposure" },
    bounds    = { doc = "bounds of the displacements in each cell, px over the exposure" },
    ids       = { uint = true, doc = "least and greatest instance + 1 in each cell; 0 for the sky" },
    culled_0 = culled, culled_1 = culled, culled_2 = culled, culled_3 = culled,
    farthest_around = { doc = "linear view depth of the farthest moving surface around each tile, metres; 0 for none" },
    max_displacement = max_displacement,
  },
  writes = { mask = { format = "r8_unorm", doc = "mask of the ray reveal, 1 where a ray is traced" } },
  if_no = { motion = { mask = 0 }, moving_rect = { mask = 0 } },
  params = {
    cell_side = blur.cell_side,
    tile      = blur.tile,
    limit     = blur.limit,
    match     = path.match,
    margin    = path.margin,
    occluder  = pass.float { 0.02, min = 0, max = 1,
      doc = "smallest relative depth difference of a nearer surface that counts as an occluder. A path that ends behind an " ..
            "occluder continues to the end of that occluder" },
  },
  counters = { off_screen = "paths that leave the image, counted as disoccluding nothing" },
}
