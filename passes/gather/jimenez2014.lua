-- SPDX-License-Identifier: MIT
-- Jimenez 2014, "Next Generation Post Processing in Call of Duty: Advanced Warfare", for any anchor.
local pass   = require "strobe.pass"
local blur   = require "passes.lib.blur"
local ports  = require "passes.lib.blur_ports"
local jitter = require "passes.lib.jitter"
local stored = require "passes.lib.stored"

return pass.compute {
  name   = "gather_jimenez2014",
  shader = "gather/jimenez2014",
  doc    = "Blur in pairs of taps whose nearer and faster side weighs both",
  fails  = "Inside a silhouette it shows the picture from outside of it as background, so that edges there appear a "
    .. "second time; outside, the background under a blurred object comes from the opposite side. Motions that cross "
    .. "the dominant one are blurred along it.",
  size   = { of = "color" },
  reads  = ports.of_layer { "slowest" },
  writes = ports.layer,
  without = ports.still,
  params = {
    samples      = blur.samples { doc = "taps along the displacement, at most" },
    count        = pass.choice { "fixed", "adaptive", default = "fixed", doc = "how many of them are taken",
      values = {
        fixed = "All of them at every pixel. Fails by reading pixels several times where the displacement is short.",
        adaptive = "The largest even number of pixels in the displacement, at least 2. Fails for displacements of a "
          .. "few pixels, which 2 taps show as copies.",
      } },
    tile         = blur.tile { 16 },
    limit        = blur.limit,
    depth_extent = blur.depth_extent { doc = "share of the depth over which order is undecided" },
    mirror       = pass.bool { true, doc = "the nearer and faster tap of a pair gives both their weight" },
    direction    = pass.choice { "none", "projected", "cosine", "opposing", default = "none",
      doc = "what a tap spreads counts by how it moves relative to the dominant displacement",
      values = {
        none = "All of it. Fails where things cross: they are blurred along the dominant displacement.",
        projected = "By the length of its displacement along the dominant one, as a share of that. Fails for slower "
          .. "surfaces that move alongside: they spread too thinly.",
        cosine = "By the cosine between the two. Fails as none does for slow crossings at acute angles.",
        opposing = "Not at all if it moves away from the pixel. No difference with the capture in the middle of the "
          .. "exposure, where all motion is to both sides; fails like none for motions across.",
      } },
    copy_below   = pass.float { 0.5, min = 0, max = 16, unit = "px",
      doc = "where nothing around spreads farther than this the picture is copied" },
    cheap_ratio  = pass.float { 0.9, min = 0, max = 1,
      doc = "where the slowest displacement around is longer than this share of the dominant one, taps are averaged" },
    jitter       = jitter.jitter,
    jitter_frame = jitter.jitter_frame,
    color_format = stored.color_format,
  },
  counters = {
    color_clamped = stored.counters.color_clamped,
    copied = "pixels that were copied, since nothing around moves",
    cheap  = "pixels that are the plain mean of their taps, since all around moves alike",
    full   = "pixels whose taps were weighed",
  },
}
