-- SPDX-License-Identifier: MIT
-- Truth: the mean over true poses at many times of the exposure. Never clamped, no tiles, no layers.
local pipeline   = require "strobe.pipeline"
local shade      = require "passes.scene.shade"
local visibility = require "passes.scene.visibility"
local traced     = require "passes.scene.visibility_traced"
local accumulate = require "passes.truth.accumulate"
local mean       = require "passes.truth.mean"
local regions    = require "passes.truth.regions"
local spread     = require "passes.truth.spread"
local stop       = require "passes.truth.stop"
local trace      = require "passes.truth.trace"
local scene      = require "scripts.pipelines.lib.scene"

local drawn = "a sample's time or place is drawn by its pixel on the screen"
local smooth = "a pixel sees all of its square, whose silhouettes are smooth where they rest too"

local snapped = "vertices are snapped to 1/256 px: a silhouette as close to a pixel's centre falls to either side"

local bool, choice, float, int = pipeline.bool, pipeline.choice, pipeline.float, pipeline.int

-- One time sample: how it is taken, by mode. Yields mean_a, mean_b and, if it can tell, regions.
local samples = {}

function samples.rays(p, seen)
  return trace { hit = seen.hit, pixel = p.pixel, mark_regions = p.mark_regions, time = "sample" }
end

-- The same by the raster pipeline, which shares no visibility with rays: to check one against the other.
function samples.raster(p)
  if p.pixel() == "box" then error("mode = raster samples pixel centres only: pixel = box needs mode = rays", 0) end
  if p.slices() > 1 then error("mode = raster draws one time per iteration: slices > 1 needs mode = rays", 0) end
  local hit = visibility { time = "sample", as = "sample_visibility" }.hit
  local color = shade { hit = hit, time = "sample", as = "sample_shade" }.color
  return accumulate { color = color }
end

local function stop_test(p, means)
  local blocks = spread { mean_a = means.mean_a, mean_b = means.mean_b }.spread
  return stop { spread = blocks, tolerance = p.tolerance, as = "stop" }.stop
end

return pipeline {
  doc = "The scene at many times of the exposure, each as it truly stands: what every method is compared to",
  kind = "truth",
  regions = {
    inner  = "pixels of the object that see something farther within the exposure",
    hidden = "pixels that see within the exposure what the capture could not see",
    outer  = "pixels outside of the object that see it within the exposure",
  },
  params = {
    mode         = choice { "rays", "raster", default = "rays",
      doc = "what finds the nearest surface at each time; only rays tell regions",
      values = {
        rays   = "Rays: whole pixels or their centres, several times at once, and regions.",
        raster = "Raster, one time after another: a check of the rays that shares none of their traversal. Fails to " ..
                 "tell regions, and samples pixel centres only.",
      },
      breaks = { raster = { mirrored = snapped } } },
    samples      = int { 1024, min = 1, max = 65536, role = "sample_count", doc = "time samples, at most" },
    times        = choice { "midpoint", "stratified", default = "midpoint", role = "sample_times",
      doc = "where a sample is in its stratum",
      values = {
        midpoint   = "In its middle: half a sample off per silhouette at most. Fails with bands where samples are few.",
        stratified = "At a random time of it, of which each pixel draws one where there are several slices: right " ..
                     "on average, with noise instead of bands. Fails by up to twice the error at each silhouette.",
      },
      breaks = { stratified = { mirrored = drawn, shifted = drawn, reversed = drawn } } },
    slices       = int { 1, min = 1, max = 64, doc = "scene times per iteration; a pixel draws one of them" },
    shading      = shade.params.shading,
    pixel        = choice { "centre", "box", default = "centre", doc = "where in the pixel a sample is",
      values = {
        centre = "In its centre, as the methods see it: differences are those of the blur. Fails with stairs at " ..
                 "silhouettes that rest.",
        box    = "Anywhere in it, evenly spread: what a pixel as a square sees. Fails as the measure of methods " ..
                 "that sample centres, which differ from it at every silhouette.",
      },
      breaks = { box = {
        still = smooth, brief = smooth, uniform = smooth, mirrored = drawn, shifted = drawn, reversed = drawn,
      } } },
    mark_regions = bool { true, role = "regions",
      doc = "find the regions in which methods differ; one more ray per sample" },
    tolerance    = float { 0, min = 0, max = 1e6, doc = "stop at this standard error of the mean; 0 = never" },
  },
  build = function(p)
    local stops, rays = p.tolerance() > 0, p.mode() == "rays"
    local seen = scene.captured(rays and traced or visibility)
    local means = pipeline.loop {
      name = "shutter", count = p.samples, times = p.times, slices = p.slices,
      until_ = stops and function(results) return results.stop end or nil,
      body = function()
        local s = samples[p.mode()](p, seen)
        return {
          mean_a = s.mean_a, mean_b = s.mean_b, regions = rays and s.regions or nil,
          stop = stops and stop_test(p, s) or nil,
        }
      end,
    }
    local result = mean { mean_a = means.mean_a, mean_b = means.mean_b }
    local where = rays and regions { regions = means.regions } or {}
    return scene.outputs(seen, {
      color = result.color, error = result.error, inner = where.inner, hidden = where.hidden, outer = where.outer,
    })
  end,
}
