-- SPDX-License-Identifier: MIT
-- Jimenez 2014, "Next Generation Post Processing in Call of Duty: Advanced Warfare". The exposure may have any position
-- relative to the raster time (anchor).
local pass      = require "strobe.pass"
local blur      = require "passes.lib.blur"
local ports     = require "passes.lib.blur_ports"
local jitter    = require "passes.lib.jitter"
local quantised = require "passes.lib.quantised"

return pass.compute {
  doc    = "Blur along the dominant displacement of the tile, by pairs of taps on both sides of the pixel; the nearer and " ..
           "faster tap of a pair sets the weight of both",
  fails  = "Inside a silhouette the background is copied from outside, so that edges there appear twice. Outside a silhouette, "
    .. "the background under the blurred object is copied from the opposite side. Surfaces that move across the dominant "
    .. "displacement are blurred along it.",
  size   = { of = "color" },
  reads  = ports.of_layer { "slowest" },
  writes = ports.layer,
  if_no = ports.no_motion,
  params = {
    samples      = blur.samples { doc = "largest number of taps along the dominant displacement" },
    count        = pass.choice { "fixed", "adaptive", default = "fixed", doc = "number of taps per pixel",
      values = {
        fixed = "`samples` taps at every pixel. Fails by reading pixels several times where the displacement is short.",
        adaptive = "One tap per pixel of the dominant displacement, rounded down to an even number, at least 2 and at most "
          .. "`samples`. Fails for displacements below 4 px: their 2 taps show as two copies.",
      } },
    tile         = blur.tile { 16 },
    limit        = blur.limit,
    depth_extent = blur.depth_extent { doc = "depth difference, as a fraction of the farther depth, that makes a surface " ..
                                             "count as fully in front of another one; smaller differences count in part" },
    mirror       = pass.bool { true, doc = "give both taps of a pair the weight of the nearer and faster one" },
    direction    = pass.choice { "none", "projected", "cosine", "opposing", default = "none",
      doc = "factor on the weight of a surface that spreads over the pixel. Each value is a rule to compute the factor " ..
            "from the displacement of the surface",
      values = {
        none = "Factor 1. Fails where surfaces move across the dominant displacement: they are blurred along it.",
        projected = "Length of the tap's displacement projected on the dominant one, divided by the length of the dominant "
          .. "one. Fails for slower surfaces with parallel motion: they spread too thinly.",
        cosine = "Magnitude of the cosine of the angle between the tap's and the dominant displacement. Fails at small "
          .. "angles, where the factor is nearly 1: surfaces are blurred along the dominant displacement, as with `none`.",
        opposing = "0 for taps that move away from the pixel within the exposure, otherwise 1. Has no effect with the "
          .. "anchor `centre`, because surfaces then blur to both sides. Fails as `none` does for motion across the dominant "
          .. "displacement.",
      } },
    copy_below   = pass.float { 0.5, min = 0, max = 16, unit = "px",
      doc = "largest blur radius of a pixel that is copied and not blurred; the radius is computed from the dominant " ..
            "displacement" },
    cheap_ratio  = pass.float { 0.9, min = 0, max = 1,
      doc = "bound on the ratio of the shortest displacement around a pixel to the dominant displacement. If the " ..
            "ratio is above the bound, the motion counts as uniform, and the taps are averaged without weights" },
    jitter       = jitter.jitter,
    jitter_frame = jitter.jitter_frame,
    color_format = quantised.color_format,
  },
  counters = {
    color_clamped = quantised.counters.color_clamped,
    copied = "pixels copied without blur, because no surface near them moves farther than `copy_below`",
    cheap  = "pixels that are the plain mean of their taps, because all surfaces near them move alike",
    full   = "pixels with weighted taps",
  },
}
