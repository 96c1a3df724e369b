-- SPDX-License-Identifier: MIT
-- One ray per pixel near motion, at a random time. Cook, Porter and Carpenter 1984, "Distributed Ray Tracing".
local pass  = require "strobe.pass"
local blur  = require "passes.lib.blur"
local jitter = require "passes.lib.jitter"
local shade = require "passes.gbuffer.shade"

local drawn = "the random sample time of a pixel depends on the position of the pixel on the screen"

return pass.trace {
  doc    = "One ray per pixel at a random time of the exposure, in tiles that a moving surface may reach",
  fails  = "The picture is noisy, because one time sample per pixel represents the whole exposure. Misses surfaces that " ..
           "enter the image where no tile around has a displacement.",
  breaks = { mirrored = drawn, shifted = drawn, reversed = drawn,
             uniform = "a pixel shows the scene at one random time, not the mean over the exposure" },
  size   = { of = "color" },
  reads  = {
    color    = { doc = "colour of the raster layer, linear radiance" },
    velocity = { doc = "screen displacement of each pixel of the raster layer, px over the exposure" },
    dominant = { doc = "longest displacement that can bring a surface to each tile, at most the displacement limit, px over " ..
                       "the exposure" },
  },
  writes = {
    noisy = { format = "rgba32f", doc = "colour of the hit, shaded as at the raster time, linear radiance; alpha 1" },
    moved = { format = "rg32f", doc = "screen displacement of the hit surface, px over the exposure" },
  },
  if_no = { motion = { noisy = "color", moved = "velocity" } },
  params = { tile = blur.tile, jitter_frame = jitter.jitter_frame },
  counters = {
    rays       = "pixels with a ray",
    not_finite = shade.counters.not_finite,
  },
}
