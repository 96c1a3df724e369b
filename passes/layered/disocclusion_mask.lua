-- SPDX-License-Identifier: MIT
-- Pixels whose background is disoccluded within the exposure, by the relative motion of foreground and background; last step
-- of the disocclusion mask.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"
local path = require "passes.lib.relative_path"
local max_displacement = require "passes.lib.max_displacement"

local culled = { doc = "two candidate displacements of hidden background per cell, px over the exposure; 1e9 for none" }

return pass.compute {
  doc    = "Pixels whose background is disoccluded within the exposure, because the foreground moves relative to the " ..
           "background",
  fails  = "Misses a disocclusion in four cases: the motion of the background is visible nowhere near the pixel, " ..
           "the background is another part of the same instance, the background enters the image from outside, or " ..
           "the motion of the background is not among the first eight motions near the tile. Also misses an object " ..
           "that moves behind a static surface, if all visible moving surfaces near the pixel are in front of that " ..
           "static surface.",
  size   = { of = "depth" },
  reads  = {
    depth     = { doc = "linear view depth, metres; +inf for the sky" },
    id        = { uint = true, doc = "instance index + 1; 0 for the sky" },
    velocity  = { doc = "screen displacement of the surface, px over the exposure" },
    bounds    = { doc = "least and greatest displacement in each cell, component by component, px over the exposure" },
    ids       = { uint = true, doc = "least and greatest instance index + 1 in each cell; 0 for the sky" },
    culled_0 = culled, culled_1 = culled, culled_2 = culled, culled_3 = culled,
    farthest_around = { doc = "linear view depth of the farthest visible moving surface around each tile, metres; 0 for none" },
    max_displacement = max_displacement,
  },
  writes = { mask = { format = "r8_unorm", doc = "mask for the pass `ray_reveal`: 1 where a ray to the background is " ..
      "traced, otherwise 0" } },
  if_no = { motion = { mask = 0 }, moving_rect = { mask = 0 } },
  params = {
    cell_side = blur.cell_side,
    tile      = blur.tile,
    limit     = blur.limit,
    match     = path.match,
    margin    = path.margin,
    occluder  = pass.float { 0.02, min = 0, max = 1,
      doc = "smallest depth difference of an occluder, as a fraction of the depth of the pixel's own object. An occluder " ..
            "is a surface, on the path that is searched from the pixel, that is nearer than this object by at least that " ..
            "difference. A path whose end is hidden by an occluder is extended to the far edge of the occluder" },
  },
  counters = { off_screen = "paths that leave the image, counted as disoccluding nothing" },
}
