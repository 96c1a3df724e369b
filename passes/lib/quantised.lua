-- SPDX-License-Identifier: MIT
-- Memory formats of colours, displacements and depths between passes. Declares the parameters, formats and counters for passes
-- and pipelines whose shaders include mixin/quantised.glsl.
local param = require "strobe.param"

local quantised = {}

quantised.velocity_format = param.choice {
  "fp32", "fp16", default = "fp32",
  doc = "memory format of displacements between passes",
  values = {
    fp32 = "Single precision, 8 bytes per pixel. Never fails: displacements keep their computed values.",
    fp16 = "Half precision, 4 bytes per pixel, rounded to nearest. Fails by up to 1/2048 of the displacement (1/32 px "
      .. "from 64 to 128 px), which moves samples across silhouettes. Displacements beyond 65504 px are shortened and counted.",
  },
}

quantised.color_format = param.choice {
  "fp32", "fp16", default = "fp32",
  doc = "memory format of colours between passes; the final picture is always fp32",
  values = {
    fp32 = "Single precision, 16 bytes per pixel. Never fails: colours keep their computed values.",
    fp16 = "Half precision, 8 bytes per pixel, rounded to nearest. Fails by up to 1/2048 of each channel. Channels beyond "
      .. "65504 are clamped and counted.",
  },
  breaks = {
    fp16 = {
      constant = "a colour between two half floats is rounded to the nearer one",
      still    = "a colour between two half floats is rounded to the nearer one",
      convex   = "a mean is rounded to a half float, which may lie outside the range of the averaged colours",
      linear   = "the rounding error of a sum differs from the sum of the rounding errors",
      mirrored = "rounding enlarges a difference in the last digit of single precision to the last digit of half precision",
      reversed = "rounding enlarges a difference in the last digit of single precision to the last digit of half precision",
      scaled   = "rounding enlarges a difference in the last digit of single precision to the last digit of half precision",
      unmasked = "two blurred layers and their composite are rounded more often than one blurred image",
    },
  },
}

quantised.depth_encoding = param.choice {
  "linear", "reversed", "inverse", "unorm24", default = "linear",
  doc = "encoding of depth in the depth buffer; filters read the decoded linear view depth",
  values = {
    linear = "View depth in single precision. Never fails: depths keep their computed values.",
    reversed = "Near distance / view depth in single precision, 0 for the sky (reversed z). Fails by about 1e-7 of the "
      .. "depth: surfaces closer together may swap or have equal depths.",
    inverse = "1 / view depth in single precision, 0 for the sky. Fails as `reversed` does.",
    unorm24 = "1 - near distance / view depth in 24 bits, 1 for the sky (conventional z). Fails at large depths: the relative "
      .. "error is up to depth / (near distance * 2^25). Surfaces farther than 2^25 near distances become sky and are "
      .. "counted.",
  },
}

quantised.velocity = { by = "velocity_format", fp32 = "rg32f", fp16 = "rg16f" }
quantised.color    = { by = "color_format", fp32 = "rgba32f", fp16 = "rgba16f" }

quantised.counters = {
  velocity_clamped = {
    doc   = "pixels with a displacement beyond 65504 px, the largest half float",
    limit = "each such displacement was shortened to 65504 px in its own direction. Use velocity_format = fp32, or shorten " ..
            "the exposure",
  },
  color_clamped = {
    doc   = "pixels with a channel beyond 65504, the largest half float",
    limit = "each such channel was clamped to 65504, so that highlights blur too dark. Use color_format = fp32, or " ..
            "scale the lights down",
  },
  depth_lost = {
    doc   = "pixels so far away that the depth encoding does not distinguish them from the sky",
    limit = "each such pixel became sky, at infinite depth. Use another depth_encoding, or move the near plane away from " ..
            "the camera",
  },
}

return quantised
