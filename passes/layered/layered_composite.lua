-- SPDX-License-Identifier: MIT
-- Composite of the raster layer and the revealed layer, per time sample.
local pass   = require "strobe.pass"
local blur   = require "passes.lib.blur"
local ports  = require "passes.lib.blur_ports"
local jitter = require "passes.lib.jitter"

local copied = { blurred = "color" }

return pass.compute {
  doc    = "Composite of the raster layer and the revealed layer: at each time sample, the colour of the nearest surface " ..
           "that is at the pixel at that time. The picture is the mean over the samples",
  fails  = "A disoccluded surface is missing if no ray revealed it, because it is behind the revealed layer or " ..
           "outside the mask. Edges are misplaced if the path of a surface deviates from its straight line (or " ..
           "curve), or the surface stretches, by more than about a pixel. If more than 4 different motions meet at " ..
           "a pixel, some are ignored.",
  breaks = {
    mirrored = "of equally long displacements, and of equally deep surfaces, the first one in raster order is used; " ..
      "in a mirrored scene this is another one",
    reversed = "if a pixel has more than 4 motions around it, the motions of the nearest taps are used; of two equally " ..
      "near taps, the one before the raster time comes first, also if time is reversed",
  },
  size   = { of = "color" },
  reads  = ports.of_both({
    "second", "second_post", "revealed_dominant", "revealed_dominant_post", "curve", "revealed_curve", "dominant_curve",
    "dominant_place",
  }, {
    moved  = { absent = 1,
      doc = "per cell, above 1/2 if a moving surface is in the cell at some time of the exposure. The colours of other " ..
            "cells are copied" },
    background = { absent = 1,
      doc = "per cell, above 1/2 if a surface revealed behind the raster layer is in the cell at some time of the " ..
            "exposure. The revealed layer is not searched in other cells" },
  }),
  writes = ports.picture,
  if_no  = { motion = copied, moving_rect = copied },
  params = {
    samples      = blur.samples { doc = "number of time samples" },
    tile         = blur.tile,
    cell_side    = blur.cell_side,
    limit        = blur.limit,
    trajectory   = blur.trajectory,
    search_taps  = pass.bool { true,
      doc = "also try the displacements of texels along the dominant displacement as candidate displacements" },
    jitter       = jitter.jitter,
    jitter_frame = jitter.jitter_frame,
  },
  counters = { fallback = "time samples without a surface at the pixel in any layer; their colour is the colour of the " ..
                          "pixel at the raster time" },
}
