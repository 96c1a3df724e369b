-- SPDX-License-Identifier: MIT
-- McGuire, Hennessy, Bukowski and Osman 2012, "A Reconstruction Filter for Plausible Motion Blur", for any anchor.
local pass   = require "strobe.pass"
local blur   = require "passes.lib.blur"
local ports  = require "passes.lib.blur_ports"
local jitter = require "passes.lib.jitter"
local stored = require "passes.lib.stored"

local every_other = "of an even number of samples to both sides every other one is taken, counted from one end"

return pass.compute {
  name   = "gather_mcguire2012",
  shader = "gather/mcguire2012",
  doc    = "Blur along the dominant displacement, weighted by cones and cylinders",
  fails  = "It is too opaque inside silhouettes (6/7 where 1/2 is true), shows a step at them, and its ramps are no "
    .. "straight lines; opacity grows with the number of samples. Background inside a silhouette is the picture from "
    .. "outside. Motions that cross the dominant one are blurred along it.",
  breaks = {
    converging = "opacity grows with the number of samples: the pixel itself weighs as much however many there are",
  },
  size   = { of = "color" },
  reads  = ports.of_layer { "second" },
  writes = ports.layer,
  without = ports.still,
  params = {
    samples      = blur.samples { doc = "taps along the displacement" },
    directions   = blur.directions {
      values = {
        one = "All along the dominant displacement, as published. Fails where things cross it: they blur along it.",
        two = "Every other one along the pixel's own, or across the dominant one where the pixel is at rest. Fails "
          .. "by spreading what moves one way along the other, since weights know distances, not directions.",
      },
      breaks = { two = { reversed = every_other } } },
    tile         = blur.tile,
    limit        = blur.limit,
    depth_extent = blur.depth_extent,
    jitter       = jitter.jitter,
    jitter_frame = jitter.jitter_frame,
    color_format = stored.color_format,
  },
  counters = { color_clamped = stored.counters.color_clamped },
}
