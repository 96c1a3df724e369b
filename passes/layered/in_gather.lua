-- SPDX-License-Identifier: MIT
-- One gather over both layers: background taps read the revealed layer where the raster layer shows a surface in front of
-- the background.
local pass   = require "strobe.pass"
local blur   = require "passes.lib.blur"
local ports  = require "passes.lib.blur_ports"
local jitter = require "passes.lib.jitter"

return pass.compute {
  doc    = "One gather whose background taps read the revealed layer where the foreground hides them",
  fails  = "A surface in front may be missed if it moves neither by the dominant displacement nor like the pixel's own " ..
           "surface, above all if it moves against both of these motions. The background is assumed to move as it does at " ..
           "the pixel: this is wrong where two backgrounds meet or the background turns. Only one layer behind the first is " ..
           "used.",
  size   = { of = "color" },
  reads  = ports.of_both({}, {
    id          = { uint = true, doc = "instance + 1, geometry + 1 of the raster layer; 0 for the sky" },
    revealed_id = { uint = true, doc = "instance + 1, geometry + 1 of the revealed surface; 0 for the sky" },
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
  counters = { fallback = "time samples whose background is in neither layer; the background at the pixel is used instead" },
}
