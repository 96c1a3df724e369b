-- SPDX-License-Identifier: MIT
-- One gather over both layers: taps that stand for the background read the revealed layer where raster saw something in
-- front of it.
local pass   = require "strobe.pass"
local blur   = require "passes.lib.blur"
local ports  = require "passes.lib.blur_ports"
local jitter = require "passes.lib.jitter"

return pass.compute {
  name   = "in_gather",
  shader = "composite/in_gather",
  doc    = "One gather whose background taps read the revealed layer where the foreground hides them",
  fails  = "A surface in front that moves neither like the fastest one around nor like what the pixel itself sees " ..
           "may be missed, above all if it moves against them. The background is taken to move as it does at the " ..
           "pixel: wrong where two backgrounds meet or where it turns. One layer behind the first, no more.",
  size   = { of = "color" },
  reads  = ports.of_both({}, {
    id          = { uint = true, doc = "instance + 1, geometry + 1; sky = 0" },
    revealed_id = { uint = true, doc = "instance + 1, geometry + 1; sky = 0" },
  }),
  writes = ports.picture,
  without = ports.still,
  params = {
    samples      = blur.samples { doc = "time samples" },
    tile         = blur.tile,
    limit        = blur.limit,
    depth_extent = blur.depth_extent,
    jitter       = jitter.jitter,
    jitter_frame = jitter.jitter_frame,
  },
  counters = { fallback = "time samples whose background neither layer had; that at the pixel stands in" },
}
