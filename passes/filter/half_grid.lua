-- SPDX-License-Identifier: MIT
-- Pixels that a filter computes if the filter runs at half resolution in tiles with heavy motion.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  doc    = "Mask of the pixels that a filter computes: one of 2x2 pixels in tiles with heavy motion, all pixels elsewhere",
  fails  = "The grid of computed pixels is fixed to the picture. If the scene is mirrored, the filtered picture is " ..
           "therefore not exactly the mirrored picture.",
  reads  = { shortest = { doc = "length of the shortest displacement in each tile, px over the exposure" } },
  writes = { mask = { format = "r8_unorm", doc = "1 at pixels that the filter computes, otherwise 0" } },
  params = {
    tile = blur.tile,
    heavy_motion = pass.float { 16, min = 1, max = 1e6, unit = "px",
      doc = "least displacement that counts as heavy motion; the filter runs at half resolution in tiles without smaller " ..
            "displacements" },
  },
}
