-- SPDX-License-Identifier: MIT
-- The parameters `jitter` and `jitter_frame` of passes and pipelines whose shaders include mixin/jitter.glsl.
local param = require "strobe.param"

local stands = "the pattern of the jitter is fixed to the screen: it is not mirrored or moved with the scene"
local runs_on = "if time is reversed, the jitter is not: it shifts the samples in the same direction as before"
local pattern = { mirrored = stands, shifted = stands, reversed = runs_on }

return {
  jitter = param.choice {
    "none", "ign", "hash", default = "none", role = "jitter",
    doc = "shift of the sample times per pixel, by up to half the distance between two samples",
    values = {
      none = "No shift: all pixels take their samples at the same times. Fails with banding: with few samples, an object "
        .. "shows as separate copies.",
      ign = "Interleaved gradient noise (Jimenez 2014): the values of every 3 x 3 pixels are evenly spread. Fails with "
        .. "diagonal hatching where noise is large.",
      hash = "White noise that depends on the seed. Fails with clumps: neighbouring pixels may get similar values.",
    },
    breaks = { ign = pattern, hash = pattern },
  },
  jitter_frame = param.choice {
    "frozen", "per_frame", default = "frozen",
    doc = "change of the jitter from frame to frame",
    values = {
      frozen = "The same pattern in every frame. Fails in motion: the pattern stays fixed while the image moves.",
      per_frame = "A new pattern in every frame, so that frames average out: `ign` is shifted by the golden ratio, `hash` has "
        .. "new values. Fails with flicker if frames are not averaged.",
    },
  },
}
