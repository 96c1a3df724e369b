-- SPDX-License-Identifier: MIT
-- Rays at adaptively chosen times: more where the visible surface changes, none where a gather is reliable.
local pass  = require "strobe.pass"
local blur  = require "passes.lib.blur"
local shade = require "passes.gbuffer.shade"

return pass.trace {
  doc    = "Blur by rays at adaptively chosen times per pixel: more rays are traced between two rays with different " ..
           "results. Cells where a gather along the motion is reliable need no rays",
  breaks = {
    linear = "the times of the rays depend on differences of colour",
    converging = "the error tolerance limits the number of rays, so more possible times need not reduce the error",
  },
  size   = { of = "color" },
  reads  = {
    color    = { doc = "colour of the raster layer, linear radiance" },
    depth    = { doc = "linear view depth of the raster layer, metres; +inf for the sky" },
    id       = { uint = true, doc = "instance index + 1, geometry index + 1 of the raster layer; 0 for the sky" },
    hit      = { uint = true, doc = "surface of the raster layer, by indices: instance + 1 (0 for the sky), geometry, " ..
                                    "triangle" },
    velocity = { doc = "screen displacement of each pixel of the raster layer, px over the exposure" },
    certain  = { doc = "per cell, 1 where a gather along the motion is reliable, 1/2 where nothing moves, 1/4 where " ..
                       "a validation ray has refuted one of these two cases, otherwise 0" },
    longest  = { doc = "longest displacement of the surfaces that reach each cell, px over the exposure" },
  },
  writes = {
    picture = { format = "rgba32f", doc = "blurred picture, linear radiance; alpha 1" },
    error   = { format = "r32f", doc = "estimated standard deviation of the picture from truth, linear radiance" },
  },
  if_no = { motion = { picture = "color", error = 0 } },
  params = {
    cell_side = blur.cell_side,
    samples   = blur.samples { doc = "number of taps along the motion where a gather is reliable" },
    pace      = pass.float { 0.02, min = 1e-6, max = 1e6, unit = "image widths",
      doc = "largest distance that the surfaces at a pixel move between two successive rays of the first, evenly " ..
            "spaced set. Further rays are traced between rays with different results" },
    allowance = pass.float { 0.01, min = 0, max = 1000,
      doc = "error tolerance: an interval between two rays is subdivided if its estimated error exceeds this value. The " ..
            "error of an interval is the error of its linear radiance times its fraction of the exposure" },
    hit_color = pass.choice { "shaded", "blended", default = "shaded", doc = "source of the colour of a hit",
      values = {
        shaded = "Shading of the hit, as at the raster time. Costs shadow rays.",
        blended = "Blend of the raster texels around the hit, of at most four that show its surface, if the error expected " ..
                  "from the range of their colours is at most a quarter of `allowance`. Other hits are shaded. Fails by " ..
                  "smoothing textures of low contrast.",
      } },
    same_depth = pass.float { 0.01, min = 0, max = 1,
      doc = "largest relative difference between the depth of a hit point and the depth of a texel that shows this point" },
  },
  counters = {
    gathered   = "pixels computed from raster colours, without a ray",
    samples    = "time samples with a ray",
    shaded     = "hits that are shaded, because no blend of raster texels and no known colour of the static background " ..
                 "replaces the shading",
    not_finite = shade.counters.not_finite,
  },
  fails  = "Surfaces that appear and disappear between two rays with equal results are missed, unless the raster layer " ..
           "shows them.",
}
