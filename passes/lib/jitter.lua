-- SPDX-License-Identifier: MIT
-- The parameters `jitter` and `jitter_frame` of whatever includes mixin/jitter.glsl, for passes and pipelines alike.
local param = require "strobe.param"

local stands = "the pattern stands on the screen: it is neither mirrored nor moved with what is seen"
local runs_on = "a shift towards the start of the exposure stays one when time runs backwards"
local pattern = { mirrored = stands, shifted = stands, reversed = runs_on }

return {
  jitter = param.choice {
    "none", "ign", "hash", default = "none", role = "jitter",
    doc = "shift of the samples per pixel, by up to half the distance of two",
    values = {
      none = "All pixels take their samples at the same times. Fails with bands: few samples show as copies.",
      ign = "Interleaved gradient noise (Jimenez 2014): each 3 x 3 pixels have nearly even values. Fails with "
        .. "diagonal hatching where noise is large.",
      hash = "White noise by the seed. Fails with clumps: neighbours are alike by chance.",
    },
    breaks = { ign = pattern, hash = pattern },
  },
  jitter_frame = param.choice {
    "frozen", "per_frame", default = "frozen",
    doc = "whether the shift of a pixel changes from frame to frame",
    values = {
      frozen = "The same pattern in each frame. Fails in motion: the picture slides under a pattern that stands.",
      per_frame = "`ign` shifted by the golden ratio from frame to frame, `hash` drawn anew, so that frames average "
        .. "out. Fails as flicker where nothing averages them.",
    },
  },
}
