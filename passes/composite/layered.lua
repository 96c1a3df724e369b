-- SPDX-License-Identifier: MIT
-- Per-time layered composite of what raster saw and what was revealed behind it.
local pass   = require "strobe.pass"
local blur   = require "passes.lib.blur"
local jitter = require "passes.lib.jitter"

return pass.compute {
  name   = "layered",
  shader = "composite/layered",
  doc    = "For each time sample, the nearest surface of any layer that is at the pixel then",
  fails  = "A surface hidden at the capture and not revealed (a second layer behind, or outside of the mask) is " ..
           "missing. Motion that bends or magnifies by more than about a pixel within the distance moved puts " ..
           "edges wrong. Where more than 4 different motions meet at a pixel some are left out.",
  breaks = {
    reversed = "of more than 4 motions around a pixel the nearest count, of equally near ones those before the capture",
  },
  size   = { of = "color" },
  reads  = {
    color             = { doc = "linear" },
    depth             = { doc = "linear view depth, metres, sky = +inf" },
    velocity          = { doc = "px over the exposure" },
    dominant          = { doc = "px over the exposure, per tile" },
    second            = { optional = true, doc = "another displacement found around, px over the exposure, per tile" },
    revealed_color    = { doc = "linear" },
    revealed_depth    = { doc = "linear view depth, metres, sky = +inf" },
    revealed_velocity = { doc = "px over the exposure" },
    revealed_valid    = { doc = "above 1/2 where something was revealed" },
    revealed_dominant = { optional = true, doc = "px over the exposure, per tile, of that layer alone" },
    after_velocity = { optional = true, doc = "px over the exposure, at times after the capture; absent: velocity" },
    after_dominant = { optional = true, doc = "px over the exposure, per tile, at times after the capture" },
    after_second   = { optional = true, doc = "second at times after the capture" },
    revealed_after_velocity = { optional = true, doc = "revealed_velocity at times after the capture" },
    revealed_after_dominant = { optional = true, doc = "revealed_dominant at times after the capture" },
  },
  writes = { blurred = { format = "rgba32f", doc = "linear; alpha 1" } },
  params = {
    samples      = blur.samples { doc = "time samples" },
    tile         = blur.tile,
    limit        = blur.limit,
    harvest      = pass.bool { true, doc = "also try the displacements met along the dominant one" },
    jitter       = jitter.jitter,
    jitter_frame = jitter.jitter_frame,
  },
  counters = { fallback = "time samples at which no layer had anything to show" },
}
