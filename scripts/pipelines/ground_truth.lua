-- SPDX-License-Identifier: MIT
-- Truth: the mean over true poses at many times of the exposure. Never clamped, no tiles, no layers.
local pipeline = require "strobe.pipeline"
local mean     = require "passes.truth.mean"
local regions  = require "passes.truth.regions"
local spread   = require "passes.truth.spread"
local stop     = require "passes.truth.stop"
local trace    = require "passes.truth.trace"
local scene    = require "scripts.pipelines.lib.scene"

local bool, choice, float, int = pipeline.bool, pipeline.choice, pipeline.float, pipeline.int

local function stop_test(p, sums)
  local blocks = spread { sum_a = sums.sum_a, sum_b = sums.sum_b }.spread
  return stop { spread = blocks, tolerance = p.tolerance, as = "stop" }.stop
end

return pipeline {
  doc = "Distributed ray tracing over the exposure: what every method is compared to",
  params = {
    samples      = int { 1024, min = 1, max = 65536, doc = "time samples, at most" },
    times        = choice { "midpoint", "stratified", default = "midpoint", doc = "where a sample is in its stratum" },
    slices       = int { 1, min = 1, max = 64, doc = "scene times per iteration; a pixel draws one of them" },
    shading      = choice { "frozen", "full", default = "frozen", doc = "shaded as at the capture, or at its time" },
    pixel        = choice { "centre", "box", default = "centre", doc = "where in the pixel a sample is" },
    mark_regions = bool { true, doc = "find the regions in which methods differ; one more ray per sample" },
    tolerance    = float { 0, min = 0, max = 1e6, doc = "stop at this standard error of the mean; 0 = never" },
  },
  build = function(p)
    local seen, stops = scene.captured(), p.tolerance() > 0
    local sums = pipeline.loop {
      name = "shutter", count = p.samples, times = p.times, slices = p.slices,
      until_ = stops and function(results) return results.stop end or nil,
      body = function()
        local s = trace {
          hit = seen.hit, shading = p.shading, pixel = p.pixel, mark_regions = p.mark_regions, time = "sample",
        }
        return { sum_a = s.sum_a, sum_b = s.sum_b, regions = s.regions, stop = stops and stop_test(p, s) or nil }
      end,
    }
    local result = mean { sum_a = sums.sum_a, sum_b = sums.sum_b }
    local where = regions { regions = sums.regions }
    return scene.outputs(seen, {
      color = result.color, error = result.error, inner = where.inner, hidden = where.hidden, outer = where.outer,
    })
  end,
}
