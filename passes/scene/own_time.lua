-- SPDX-License-Identifier: MIT
-- What no layer explains, by rays at their own time.
local pass  = require "strobe.pass"
local captured_color = require "passes.lib.captured_color"
local shade = require "passes.scene.shade"

return pass.trace {
  name   = "own_time",
  shader = "scene/own_time",
  doc    = "For each sample of a pixel at which no layer has anything, a ray at that time",
  size   = { of = "seen" },
  reads  = {
    seen  = { pointwise = true, doc = "linear, the samples that are explained over the number of all; alpha: their share" },
    open  = { uint = true, doc = "a bit for each time at which nothing explains what is seen" },
    hit   = { uint = true, doc = "what raster saw at the capture: instance + 1 (0 = sky), geometry, primitive" },
    color = { doc = "linear, of that" },
    depth = { doc = "its linear view depth, metres; sky = +inf" },
    id    = { uint = true, doc = "its instance + 1, geometry + 1; sky = 0" },
    revealed_color = { doc = "linear, of what was revealed behind it" },
    revealed_depth = { doc = "its linear view depth, metres; sky = +inf" },
    revealed_id    = { uint = true, doc = "its instance + 1, geometry + 1; sky = 0" },
    revealed_valid = { doc = "above 1/2 where something was revealed" },
  },
  writes = { picture = { format = "rgba32f", doc = "linear; alpha 1" } },
  without = { motion = { picture = "seen" }, reached = { picture = "seen" } },
  params = {
    audit      = pass.float { 0.01, min = 0, max = 1,
      doc = "share of the blocks of 4x2 pixels within reach of motion whose resolved samples are checked by rays" },
    wrong_by   = pass.float { 0.1, min = 0, max = 1,
      doc = "share of its colour by which the mean of a pixel's explained samples may be off" },
    shades_unlike = captured_color.shades_unlike,
    unlike        = captured_color.unlike,
    detail_below  = captured_color.detail_below,
    same_depth    = captured_color.same_depth,
  },
  counters = {
    samples = "samples of pixels that had a ray at their own time",
    shaded  = "of those, samples whose surface the capture does not see: they were shaded",
    audited = "pixels in which what layers explain was traced as well",
    wrong   = "of those, pixels that layers explain wrongly",
    not_finite = shade.counters.not_finite,
  },
  fails  = "Times are those of at most 64 parts of the exposure, without jitter. Never by what it sees.",
}
