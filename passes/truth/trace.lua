-- SPDX-License-Identifier: MIT
-- One time sample of ground truth per pixel, added to two interleaved halves; repeated over the shutter by a loop.
-- Source: Cook, Porter, Carpenter, "Distributed Ray Tracing", SIGGRAPH '84.
local pass  = require "strobe.pass"
local shade = require "passes.scene.shade"

return pass.trace {
  name   = "truth_trace",
  shader = "truth/trace",
  doc    = "One ray per pixel at a time of its own, from the scene's true pose at that time",
  size   = { of = "hit" },
  reads  = {
    hit = { uint = true, doc = "what each pixel sees at the capture: instance + 1 (0 = sky), geometry, primitive" },
    listed = { buffer = true, optional = true, doc = "the pixels that take part; absent: all" },
    sure = { optional = true, uint = true, doc = "shadows that no ray has to find, of shadow_shafts" },
    known_hit     = { optional = true, uint = true, doc = "surfaces and triangles that samples see, of truth_agreement" },
    known_shadows = { optional = true, uint = true, doc = "shadows that no ray has to find, of truth_agreement" },
    even_color    = { optional = true, doc = "colours of what is at rest that need no more samples, of truth_agreement" },
    first_ground  = { optional = true, uint = true, doc = "`ground` of the samples before these" },
    first_still   = { optional = true, doc = "`still` of the samples before these" },
    first_regions = { optional = true, uint = true, doc = "`regions` of the samples before these" },
  },
  over = "listed",
  updates = {
    mean_a  = { format = "rgba32f", doc = "mean radiance of one half of the samples; a = their number" },
    mean_b  = { format = "rgba32f", doc = "mean radiance of the others; a = their number" },
    regions = { format = "r32ui", doc = "bits: 1 inner, 2 hidden, 4 outer, 8 self" },
    still   = { format = "rgba32f", doc = "rgb: mean colour of what is at rest; a: number of samples" },
    unlike  = { format = "r32f", doc = "the farthest of its colours from the mean before it, in parts of that" },
    ground  = { format = "rgba32ui",
      doc = "what samples have seen at rest, or through whole pixels where that is nothing in motion: 0 nothing, 1 sky, " ..
            "2 + instance, 2^32 - 1 several; geometry, triangle, distance" },
    shadows = { format = "rgba32ui",
      doc = "of two instances: whose, first 16 lights by bits (free at all that asked; " ..
      "from bit 16 on blocked; both: none did)" },
  },
  counters = {
    not_finite = shade.counters.not_finite,
    audited    = "samples that were traced in full, to check what is known without",
    missed     = "of those, samples that see another surface or triangle, or another shadow",
  },
  params = {
    shading = shade.params.shading {
      doc = "pose at which points are shaded: the capture's (what a blur filter can reach), or the sample's own time" },
    pixel   = pass.choice { "centre", "box", default = "centre",
      doc = "sample positions: the centre, or all over the pixel" },
    in_turn = pass.bool { false, wired = true,
      doc = "places in the pixel go by the sample's turn, evenly spread wherever the loop stops; else by its part of the " ..
            "exposure, evenly spread together with the times" },
    shadow_tile = shade.params.shadow_tile,
    every_ray = pass.bool { false, doc = "trace what other samples have found already" },
    keeps_notes = pass.bool { false, wired = true, doc = "keep what samples see, for truth_agreement" },
    surveys = pass.bool { false, wired = true,
      doc = "before a moving camera, see and keep what the capture shows: a second ray, and its shadows" },
    audit = pass.float { 0.01, min = 0, max = 1,
      doc = "share of the blocks of 4x2 pixels that trace every ray, to check the rays that others are spared" },
    once_where_still = pass.bool { false, role = "still_once",
      doc = "what nothing in motion reaches is sampled once, for all samples: right for centres under frozen shading" },
    mark_regions = pass.bool { true, doc = "find the regions in which methods differ; one more ray per sample" },
  },
}
