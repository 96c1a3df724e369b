-- SPDX-License-Identifier: MIT
-- Ground truth: the mean of the scene in its true poses at many times of the exposure. Blur methods approximate this mean by
-- displacements, tiles and layers; ground truth uses none of these.
local pipeline   = require "strobe.pipeline"
local shade      = require "passes.gbuffer.shade"
local visibility = require "passes.gbuffer.visibility"
local traced     = require "passes.gbuffer.visibility_traced"
local accumulate = require "passes.truth.accumulate"
local agreement  = require "passes.truth.sample_consensus"
local mean       = require "passes.truth.mean"
local regions    = require "passes.truth.regions"
local trace      = require "passes.truth.sample"
local scene      = require "scripts.pipelines.lib.scene"
local truth      = require "scripts.pipelines.lib.truth"

local drawn = "the random time or position of a sample depends on the position of the pixel on the screen"
local smooth = "samples cover the whole pixel, so static silhouettes are smooth; in the raster image they have steps"

local snapped = "the rasteriser snaps vertices to 1/256 px, so that a silhouette may cross the centre of a pixel"

-- Adds one time sample by rasterisation to the mean. Rasterisation and rays share no visibility code, so that each can check
-- the other.
local function rastered_sample(p)
  if p.pixel() == "box" then error("mode = raster samples pixel centres only; pixel = box needs mode = rays or brute", 0) end
  if p.slices() > 1 then error("mode = raster draws one time per iteration; slices > 1 needs mode = rays or brute", 0) end
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
  doc = "Mean of the scene in its true poses at many times of the exposure: the reference for every method",
  kind = "truth",
  regions = {
    inner  = "pixels that show a farther instance at some time of the exposure than at the raster time",
    hidden = "pixels that show at some time of the exposure a point that is occluded at the raster time",
    outer  = "pixels that show a nearer instance at some time of the exposure than at the raster time",
    self   = "pixels that show at some time of the exposure a point of their raster-time instance that is occluded at the " ..
             "raster time",
  },
  params = {
    mode         = choice { "rays", "brute", "raster", default = "rays",
      doc = "method that determines the nearest surface at each time; `raster` does not compute the error regions " ..
            "(inner, hidden, outer, self)",
      values = {
        rays   = "Rays through the whole pixel or its centre, at several times in one iteration. Static surfaces are traced " ..
                 "once, moving surfaces at each time. A ray is skipped if the first samples of the pixel and its " ..
                 "neighbours agree on the result. With a static camera they agree on a surface, its shadows or one static " ..
                 "colour. With a moving camera they agree on the surface and shadows of a point that is visible at the " ..
                 "raster time. Validation rays test the skipped rays in some pixels. Fails to find surfaces that none of " ..
                 "the first samples hits.",
        brute  = "The samples of `rays`, each traced in full with its shadow rays. No ray is skipped: a reference for `rays`.",
        raster = "The scene is rasterised at one time after another. This checks `rays`, because it shares no traversal " ..
                 "code with them. Computes no regions for errors, and samples pixel centres only.",
      },
      breaks = { raster = { mirrored = snapped } } },
    samples      = int { 1024, min = 1, max = 65536, role = "sample_count", doc = "largest number of time samples" },
    times        = choice { "midpoint", "stratified", default = "midpoint", role = "sample_times",
      doc = "time of a sample within its stratum (its part of the exposure)",
      values = {
        midpoint   = "The middle. A silhouette that crosses the pixel causes an error of at most half a sample's weight. " ..
                     "Fails with bands where samples are few.",
        stratified = "A random time; with several slices, each pixel takes the time of a random slice. Unbiased, with noise " ..
                     "instead of bands. Fails by up to twice the error of `midpoint` at each silhouette.",
      },
      breaks = { stratified = { mirrored = drawn, shifted = drawn, reversed = drawn } } },
    slices       = int { 1, min = 1, max = 64, doc = "number of sample times per iteration of the loop over time " ..
                                                 "samples. Each time has its own pose of the scene; each pixel uses " ..
                                                 "one of the times, chosen at random",
      breaks = { other = { mirrored = drawn, shifted = drawn, reversed = drawn } } },
    shading      = shade.params.shading,
    pixel        = choice { "centre", "box", default = "centre", doc = "position of a sample in its pixel",
      values = {
        centre = "The centre, as in the blur pipelines, so differences from truth are errors of the blur alone. Fails with " ..
                 "stairs at static silhouettes.",
        box    = "Positions spread evenly over the pixel: a box filter. Fails as the reference of pipelines that sample " ..
                 "centres, because their pictures differ at every silhouette.",
      },
      breaks = { box = {
        still = smooth, brief = smooth, uniform = smooth, mirrored = drawn, shifted = drawn, reversed = drawn,
      } } },
    first_samples = int { 0, min = 0, max = 4096,
      doc = "number of samples that are taken first. A later sample skips a ray if all these samples, at the pixel and " ..
            "its neighbours, agree on the result of that ray. 0: an eighth of `samples`, but at least 8, and at most 64 " ..
            "if `tolerance` is above 0" },
    even_within  = agreement.params.even_within,
    mark_regions = bool { true, role = "regions",
      doc = "find the regions of the error report (inner, hidden, outer, self); costs one more ray per sample" },
    validation_share = trace.params.validation_share,
    tolerance        = float { 0, min = 0, max = 1e6,
      doc = "bound of the standard error of the mean, linear radiance: sampling stops when the error is at most " ..
            "this bound. 0: sampling does not stop early" },
  },
  build = function(p)
    local rays = p.mode() ~= "raster"
    local raster = scene.raster(rays and traced or visibility)
    local means = (rays and truth.everywhere or rastered)(p, raster)
    local result = mean { mean_a = means.mean_a, mean_b = means.mean_b }
    local where = rays and regions { regions = means.regions } or {}
    return scene.outputs(raster, {
      color = result.color, error = result.error,
      inner = where.inner, hidden = where.hidden, outer = where.outer, self = where.self,
    })
  end,
}
