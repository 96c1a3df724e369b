-- SPDX-License-Identifier: MIT
-- The parameters `jitter` and `jitter_frame` of passes and pipelines whose shaders include mixin/jitter.glsl.
local param = require "strobe.param"

local stands = "the pattern is fixed to the screen: it is not mirrored or moved with the scene"
local runs_on = "the jitter shifts samples in the same direction in time when time runs backwards"
local pattern = { mirrored = stands, shifted = stands, reversed = runs_on }

return {
  jitter = param.choice {
    "none", "ign", "hash", default = "none", role = "jitter",
    doc = "shift of the sample times per pixel, by up to half the distance between two samples",
    values = {
      none = "No shift: all pixels take their samples at the same times. Fails with banding: few samples show as copies.",
      ign = "Interleaved gradient noise (Jimenez 2014): every 3 x 3 pixels have evenly spread values. Fails with "
        .. "diagonal hatching where noise is large.",
      hash = "White noise from the seed. Fails with clumps: neighbouring pixels may get similar values.",
    },
    breaks = { ign = pattern, hash = pattern },
  },
  jitter_frame = param.choice {
    "frozen", "per_frame", default = "frozen",
    doc = "change of the jitter from frame to frame",
    values = {
      frozen = "The same pattern in every frame. Fails in motion: the image slides under a fixed pattern.",
      per_frame = "A new pattern in every frame, so that frames average out: `ign` is shifted by the golden ratio, `hash` is "
        .. "drawn anew. Fails as flicker if frames are not averaged.",
    },
  },
}
