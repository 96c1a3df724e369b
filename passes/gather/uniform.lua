-- SPDX-License-Identifier: MIT
-- Time-uniform gather: a tap counts as 1/N of the exposure if its own motion passes over the pixel, else not at all.
local pass   = require "strobe.pass"
local blur   = require "passes.lib.blur"
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
  reads  = {
    color        = { doc = "linear" },
    depth        = { doc = "linear view depth, metres, sky = +inf" },
    velocity     = { doc = "px over the exposure" },
    dominant     = { doc = "px over the exposure, per tile" },
    after_velocity = { optional = true, doc = "px over the exposure, at times after the capture; absent: velocity" },
    after_dominant = { optional = true, doc = "px over the exposure, per tile, at times after the capture" },
    valid        = { optional = true, doc = "above 1/2 where the layer holds something; absent: everywhere" },
    behind_depth = { optional = true, doc = "linear view depth of what was revealed behind each pixel" },
    behind_valid = { optional = true, doc = "above 1/2 where something was; absent: nowhere" },
  },
  writes = { blurred = { format = stored.color,
    doc = "linear, times alpha; alpha below 1 only over something revealed" } },
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
