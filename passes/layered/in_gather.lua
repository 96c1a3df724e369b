-- SPDX-License-Identifier: MIT
-- One gather over both layers: background taps read the revealed layer where the raster layer shows a surface in front of
-- the background.
local pass   = require "strobe.pass"
local blur   = require "passes.lib.blur"
local ports  = require "passes.lib.blur_ports"
local jitter = require "passes.lib.jitter"

return pass.compute {
  doc    = "One gather over both layers: taps of the background read the revealed layer where the foreground hides the " ..
           "background",
  fails  = "A surface in front may be missed if it moves neither by the dominant displacement nor like the pixel's own " ..
           "surface, above all if it moves against both of these motions. The background is assumed to move everywhere as " ..
           "it moves at the pixel: this is wrong where two backgrounds meet or the background rotates. Only one layer " ..
           "behind the first is used.",
  size   = { of = "color" },
  reads  = ports.of_both({}, {
    id          = { uint = true, doc = "instance index + 1, geometry index + 1 of the raster layer; 0 for the sky" },
    revealed_id = { uint = true, doc = "instance index + 1, geometry index + 1 of the surface revealed behind the raster " ..
                                       "layer; 0 for the sky" },
  }),
  writes = ports.picture,
  if_no = ports.no_motion,
  params = {
    samples      = blur.samples { doc = "number of time samples" },
    tile         = blur.tile,
    limit        = blur.limit,
    depth_extent = blur.depth_extent,
    jitter       = jitter.jitter,
    jitter_frame = jitter.jitter_frame,
  },
  counters = {
    fallback = "time samples with a background that neither layer shows; the background at the pixel is used instead",
  },
}
