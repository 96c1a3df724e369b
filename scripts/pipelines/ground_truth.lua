-- SPDX-License-Identifier: MIT
-- Truth: the mean over true poses at many times of the exposure. Never clamped, no tiles, no layers.
local pipeline   = require "strobe.pipeline"
local shade      = require "passes.scene.shade"
local visibility = require "passes.scene.visibility"
local traced     = require "passes.scene.visibility_traced"
local accumulate = require "passes.truth.accumulate"
local agreement  = require "passes.truth.agreement"
local mean       = require "passes.truth.mean"
local regions    = require "passes.truth.regions"
local trace      = require "passes.truth.trace"
local scene      = require "scripts.pipelines.lib.scene"
local truth      = require "scripts.pipelines.lib.truth"

local drawn = "a sample's time or place is drawn by its pixel on the screen"
local smooth = "a pixel sees all of its square, whose silhouettes are smooth where they rest too"

local snapped = "vertices are snapped to 1/256 px: a silhouette as close to a pixel's centre falls to either side"

-- The same by the raster pipeline, which shares no visibility with rays: to check one against the other.
local function rastered_sample(p)
  if p.pixel() == "box" then error("mode = raster samples pixel centres only: pixel = box needs mode = rays", 0) end
  if p.slices() > 1 then error("mode = raster draws one time per iteration: slices > 1 needs mode = rays", 0) end
  local hit = visibility { time = "sample", as = "sample_visibility" }.hit
  local color = shade { hit = hit, time = "sample", as = "sample_shade" }.color
  return accumulate { color = color }
end

local function rastered(p)
  return pipeline.loop {
    name = "shutter", count = p.samples, times = p.times,
    until_ = p.tolerance() > 0 and function(results) return results.stop end or nil,
    body = function()
      local s = rastered_sample(p)
      return { mean_a = s.mean_a, mean_b = s.mean_b, stop = p.tolerance() > 0 and truth.stop_test(p, s) or nil }
    end,
  }
end

local bool, choice, float, int = pipeline.bool, pipeline.choice, pipeline.float, pipeline.int

return pipeline {
  doc = "The scene at many times of the exposure, each as it truly stands: what every method is compared to",
  kind = "truth",
  regions = {
    inner  = "pixels of the object that see something farther within the exposure",
    hidden = "pixels that see within the exposure what the capture could not see",
    outer  = "pixels outside of the object that see it within the exposure",
    self   = "pixels of an object that see within the exposure what the capture could not see of that same object",
  },
  params = {
    mode         = choice { "rays", "brute", "raster", default = "rays",
      doc = "what finds the nearest surface at each time; only rays tell regions",
      values = {
        rays   = "Rays: whole pixels or their centres, several times at once, and regions. What is at rest is found " ..
                 "once, and what moves is traced before it at each time; before a camera at rest, what all of the first " ..
                 "samples of a pixel and its neighbours agree about, a surface, its shadows or one colour of what is " ..
                 "at rest, holds for the others, before a moving one what they see at the capture, for the points that the " ..
                 "capture shows; an audit traces it all the same in some pixels. Fails to see what lies between all of " ..
                 "these samples.",
        brute  = "The same samples, each traced in full with its shadows: what the audit compares with, everywhere.",
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
    slices       = int { 1, min = 1, max = 64, doc = "scene times per iteration; a pixel draws one of them",
      breaks = { other = { mirrored = drawn, shifted = drawn, reversed = drawn } } },
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
    first_samples = int { 0, min = 0, max = 4096,
      doc = "samples that are taken everywhere, and traced in full; 0 = an eighth of all, at least 8; of those that a " ..
            "tolerance may stop at most 64" },
    even_within  = agreement.params.even_within,
    mark_regions = bool { true, role = "regions",
      doc = "find the regions in which methods differ; one more ray per sample" },
    audit        = trace.params.audit,
    tolerance    = float { 0, min = 0, max = 1e6, doc = "stop at this standard error of the mean; 0 = never" },
  },
  build = function(p)
    local rays = p.mode() ~= "raster"
    local seen = scene.captured(rays and traced or visibility)
    local means = (rays and truth.everywhere or rastered)(p, seen)
    local result = mean { mean_a = means.mean_a, mean_b = means.mean_b }
    local where = rays and regions { regions = means.regions } or {}
    return scene.outputs(seen, {
      color = result.color, error = result.error,
      inner = where.inner, hidden = where.hidden, outer = where.outer, self = where.self,
    })
  end,
}
