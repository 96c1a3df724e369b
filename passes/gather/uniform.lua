-- SPDX-License-Identifier: MIT
-- Time-uniform gather: a tap counts as 1/N of the exposure if its own motion passes over the pixel, else not at all.
local pass   = require "strobe.pass"
local blur   = require "passes.lib.blur"
local ports  = require "passes.lib.blur_ports"
local jitter = require "passes.lib.jitter"
local stored = require "passes.lib.stored"

return pass.compute {
  name   = "gather_uniform",
  shader = "gather/uniform",
  doc    = "Blur along the dominant displacement, each tap an equal share of the exposure",
  fails  = "Without a revealed layer the background inside a silhouette is the picture from outside. Where background "
    .. "moves under a moving silhouette the product of two means is not the mean of the product. Motions that cross "
    .. "the dominant one by more than 3/4 px are not found.",
  size   = { of = "color" },
  reads  = ports.of_layer { "after_velocity", "after_dominant" },
  writes = ports.layer,
  without = ports.still,
  params = {
    samples      = blur.samples { doc = "taps along the displacement" },
    tile         = blur.tile,
    limit        = blur.limit,
    depth_extent = blur.depth_extent,
    jitter       = jitter.jitter,
    jitter_frame = jitter.jitter_frame,
    color_format = stored.color_format,
  },
  counters = { color_clamped = stored.counters.color_clamped },
}
