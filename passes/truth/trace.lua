-- SPDX-License-Identifier: MIT
-- One time sample of ground truth per pixel, added to two interleaved halves; repeated over the shutter by a loop.
-- Source: Cook, Porter, Carpenter, "Distributed Ray Tracing", SIGGRAPH '84.
local pass  = require "strobe.pass"
local shade = require "passes.scene.shade"
local adaptive = require "passes.lib.adaptive"

return pass.trace {
  name   = "truth_trace",
  shader = "truth/trace",
  doc    = "One ray per pixel at a time of its own, from the scene's true pose at that time",
  size   = { of = "hit" },
  reads  = {
    hit = { uint = true, doc = "what each pixel sees at the capture: instance + 1 (0 = sky), geometry, primitive" },
    budget = { optional = true, doc = "samples of each tile; absent: all take all" },
  },
  writes = {
    sample_id       = { format = "rg32ui", doc = "instance + 1, geometry + 1 this iteration's ray hit; sky = 0" },
    sample_position = { format = "rgba32f",
      doc = "where that point is at the capture, world axes, from the capture's camera, metres; a = 1 on a hit" },
  },
  updates = {
    mean_a  = { format = "rgba32f", doc = "mean radiance of even iterations; a = their number" },
    mean_b  = { format = "rgba32f", doc = "mean radiance of odd iterations; a = their number" },
    regions = { format = "r32ui", doc = "bits: 1 inner, 2 hidden, 4 outer" },
    still   = { format = "rgba32f",
      doc = "colour of what stood last as at the capture; a = instance + 2, 1 of the sky, 0 before" },
  },
  counters = { not_finite = shade.counters.not_finite },
  params = {
    shading = shade.params.shading {
      doc = "pose at which points are shaded: the capture's (what a blur filter can reach), or the sample's own time" },
    pixel   = pass.choice { "centre", "box", default = "centre",
      doc = "sample positions: the centre, or all over the pixel" },
    taken = pass.int { 0, min = 0, max = 1048576, doc = "samples that loops before this one have taken" },
    least_budget = pass.float { 0, min = 0, max = 1e6, doc = "samples of a tile that takes part" },
    tile = adaptive.tile,
    once_where_still = pass.bool { false, role = "still_once",
      doc = "what nothing in motion reaches is sampled once, for all samples: right for centres under frozen shading" },
    mark_regions = pass.bool { true, doc = "find the regions in which methods differ; one more ray per sample" },
  },
}
