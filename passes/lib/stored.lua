-- SPDX-License-Identifier: MIT
-- How colours, displacements and depths are kept between passes: parameters, formats and counters of whatever includes
-- mixin/stored.glsl, for passes and pipelines alike.
local param = require "strobe.param"

local stored = {}

stored.velocity_format = param.choice {
  "fp32", "fp16", default = "fp32",
  doc = "numbers in which displacements are kept between passes",
  values = {
    fp32 = "Single precision, 8 bytes per pixel. Nothing to fail: displacements are as they were computed.",
    fp16 = "Half floats, 4 bytes per pixel, rounded to the nearest. Fails by up to 1/2048 of the displacement (1/32 px "
      .. "from 64 to 128 px), which moves samples across silhouettes, and beyond 65504 px, where displacements are "
      .. "shortened and counted.",
  },
}

stored.color_format = param.choice {
  "fp32", "fp16", default = "fp32",
  doc = "numbers in which colours are kept between passes; the picture that comes out is always fp32",
  values = {
    fp32 = "Single precision, 16 bytes per pixel. Nothing to fail: colours are as they were computed.",
    fp16 = "Half floats, 8 bytes per pixel, rounded to the nearest. Fails by up to 1/2048 of each channel, and beyond "
      .. "65504, where channels are clamped and counted.",
  },
  breaks = {
    fp16 = {
      constant = "a colour that is no half float is rounded to one",
      still    = "a colour that is no half float is rounded to one",
      convex   = "a mean is rounded to a half float, which may lie outside of what it is a mean of",
      linear   = "a sum is rounded otherwise than its parts",
      mirrored = "rounding makes the last digit of single precision one of half floats",
      reversed = "rounding makes the last digit of single precision one of half floats",
      scaled   = "rounding makes the last digit of single precision one of half floats",
      unmasked = "what is blurred in two layers is rounded once more",
    },
  },
}

stored.depth_encoding = param.choice {
  "linear", "reversed", "inverse", "unorm24", default = "linear",
  doc = "number that the depth buffer holds; filters read what comes back from it as linear view depth",
  values = {
    linear = "The view depth itself in single precision. Nothing to fail: depths are as they were computed.",
    reversed = "Near distance / view depth in single precision, sky 0 (reversed z). Fails by about 1e-7 of the depth, "
      .. "so that surfaces closer together than that may swap or tie.",
    inverse = "1 / view depth in single precision, sky 0. Fails as reversed does.",
    unorm24 = "1 - near distance / view depth in 24 bits, sky 1 (the standard z of old). Fails in the distance: by up "
      .. "to depth / (near distance * 2^25) of the depth, and everything farther than 2^25 near distances is sky, "
      .. "which is counted.",
  },
}

stored.velocity = { by = "velocity_format", fp32 = "rg32f", fp16 = "rg16f" }
stored.color    = { by = "color_format", fp32 = "rgba32f", fp16 = "rgba16f" }

stored.counters = {
  velocity_clamped = {
    doc   = "pixels whose displacement is beyond the 65504 px of a half float",
    limit = "it was shortened to that, in its direction. Take velocity_format = fp32, or shorten the exposure",
  },
  color_clamped = {
    doc   = "pixels with a channel beyond the 65504 of a half float",
    limit = "it was clamped to that: what is as bright blurs darker than it should. Take color_format = fp32, or scale " ..
            "the lights down",
  },
  depth_lost = {
    doc   = "pixels so far away that the depth encoding cannot tell them from the sky",
    limit = "they became sky, at infinite depth. Take another depth_encoding, or move the near plane away from the camera",
  },
}

return stored
