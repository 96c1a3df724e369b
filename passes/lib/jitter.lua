-- SPDX-License-Identifier: MIT
-- The parameters `jitter` and `jitter_frame` of whatever includes mixin/jitter.glsl, for passes and pipelines alike.
local param = require "strobe.param"

local stands = "the pattern stands on the screen: it is neither mirrored nor moved with what is seen"
local runs_on = "a shift towards the start of the exposure stays one when time runs backwards"
local pattern = { mirrored = stands, shifted = stands, reversed = runs_on }

local shared = {
  jitter = param.choice {
    "none", "ign", "r2", "blue", "checker", "hash", default = "none", role = "jitter",
    doc = "shift of the samples per pixel, by up to half the distance of two",
    values = {
      none = "All pixels take their samples at the same times. Fails with bands: few samples show as copies.",
      ign = "Interleaved gradient noise (Jimenez 2014): each 3 x 3 pixels have nearly even values. Fails with "
        .. "diagonal hatching where noise is large.",
      r2 = "The lattice of the R2 sequence (Roberts 2018), even along every row and column. Fails with visible regular "
        .. "patterns.",
      blue = "The rank of a hash among those of the 5 x 5 pixels around: without low frequencies, so that a small blur "
        .. "removes it. Fails by costing 25 hashes per pixel, and by remaining grainier than tables of blue noise.",
      checker = "A quarter of the distance to either side, in a checkerboard (2 values). Fails where 2 are too few.",
      hash = "White noise by the seed. Fails with clumps: neighbours are alike by chance.",
    },
    breaks = {
      ign = pattern, r2 = pattern, blue = pattern, hash = pattern,
      checker = { mirrored = stands, reversed = runs_on },
    },
  },
  jitter_frame = param.choice {
    "frozen", "per_frame", default = "frozen",
    doc = "whether the shift of a pixel changes from frame to frame",
    values = {
      frozen = "The same pattern in each frame. Fails in motion: the picture slides under a pattern that stands.",
      per_frame = "Shifted by the golden ratio from frame to frame, hash drawn anew, so that frames average out. Fails "
        .. "as flicker where nothing averages them.",
    },
  },
}

-- Of what has no tiles, whose picture of a scene that moves by an odd number of pixels is the moved picture without it.
shared.without_tiles = shared.jitter {
  breaks = { ign = pattern, r2 = pattern, blue = pattern, hash = pattern, checker = pattern },
}

return shared
