-- SPDX-License-Identifier: MIT
-- The number of samples of each tile.
local pass = require "strobe.pass"
local adaptive = require "passes.lib.adaptive"

return pass.compute {
  name   = "truth_sample_budget",
  shader = "truth/sample_budget",
  doc    = "Samples of each tile, more where they differ more",
  fails  = "What crosses a tile and its neighbours between two of the first samples is not known to be there: where " ..
           "anything can move a tile has `least` of the samples all the same.",
  size   = { of = "tile_error" },
  reads  = {
    tile_error = { doc = "linear radiance: of each tile; the larger of that and of the mean around it" },
    rate       = { doc = "one texel: samples for an error of 1; the most that any tile gets" },
  },
  writes = { budget = { format = "r32f", doc = "samples" } },
  params = {
    samples = adaptive.samples,
    order   = adaptive.order,
    tile    = adaptive.tile,
    least   = pass.float { 0.25, min = 0, max = 1, doc = "share of `samples` that a tile has where anything can move" },
    audit   = adaptive.audit,
  },
}
