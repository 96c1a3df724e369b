-- SPDX-License-Identifier: MIT
-- Ground truth by rays at many times. The functions take a table `p` of settings: mode, samples, times, slices, pixel, shading,
-- mark_regions, tolerance, first_samples, even_within, validation_share. Each setting is a parameter of a pipeline or a
-- plain value. The pipeline ground_truth documents the settings.
local pipeline          = require "strobe.pipeline"
local agreement         = require "passes.truth.sample_consensus"
local join_half_buffers = require "passes.truth.join_half_buffers"
local half_difference   = require "passes.truth.half_difference"
local stop              = require "passes.truth.stop"
local trace             = require "passes.truth.sample"
local compact             = require "scripts.pipelines.lib.compact"

local truth = {}

-- Returns the value of `setting`, which is either a parameter of the pipeline or a plain value.
local function valued(setting)
  local kind = type(setting)
  if kind == "number" or kind == "string" or kind == "boolean" then return setting end
  return setting()
end

-- Adds one time sample by rays to the means. Time samples are taken in two loops (see truth.everywhere). The second loop
-- skips a ray if all samples of the first loop agree on the result of that ray. Fields of `t`:
--   before       second loop: the results of the first loop; nil: this is the first or the only loop
--   consensus    second loop: the results that all samples of the first loop agree on; nil: no ray is skipped
--   every_ray    true: trace every ray of the sample
--   stats        true (first loop): store per-pixel statistics of the samples, which the consensus is computed from
--   probes       true (first loop): if the camera moves, also trace a ray at the raster time, with its shadow rays. The
--                consensus is then computed from these rays, because the rays of the samples move with the camera
--   pixel_list   list of the pixels to sample; nil: all pixels
--   as           name of the node
function truth.traced_sample(p, raster, t)
  local before, consensus = t.before or {}, t.consensus or {}
  local frozen = valued(p.shading) == "frozen"
  return trace {
    hit = raster.hit, pixel = p.pixel, mark_regions = p.mark_regions, time = "sample", every_ray = t.every_ray,
    writes_stats = t.stats, probes = t.probes, in_turn = valued(p.tolerance) > 0 or nil,
    validation_share = p.validation_share, as = t.as,
    light_visibility = frozen and not t.every_ray and not t.consensus and raster.light_visibility or nil,
    pixel_list = t.pixel_list, known_hit = consensus.known_hit, known_shadows = consensus.known_shadows,
    even_color = consensus.even_color,
    first_static = before.static_background, first_static_mean = before.static_mean, first_regions = before.regions,
    static_once_per_loop = not t.every_ray and valued(p.pixel) == "centre" and frozen,
  }
end

-- Returns an image of one texel: 1 if the standard error of the mean is within the tolerance, so that the loop over time
-- samples ends; otherwise 0.
function truth.stop_test(p, means)
  local blocks = half_difference { mean_a = means.mean_a, mean_b = means.mean_b }.half_difference
  return stop { half_difference = blocks, tolerance = p.tolerance, as = "stop" }.stop
end

-- Joins two sets of samples: means weighted by their numbers of samples, and the union of the regions.
function truth.joined(first, more, name)
  return join_half_buffers {
    first_a = first.mean_a, first_b = first.mean_b, first_regions = first.regions,
    more_a = more.mean_a, more_b = more.mean_b, more_regions = more.regions, as = name,
  }
end

-- Loops over some of the time samples of the exposure: over `t.count` of `t.parts` samples, from number `t.first` on. `t` also
-- has the fields of truth.traced_sample. The stop test includes the results of earlier samples, `t.before`.
function truth.shutter(p, raster, t)
  local stops = valued(p.tolerance) > 0 and not t.stats
  return pipeline.loop {
    name = t.name, count = t.count, first = t.first, parts = t.parts, times = p.times, slices = p.slices,
    until_ = stops and function(results) return results.stop end or nil,
    body = function()
      local s = truth.traced_sample(p, raster, t)
      return {
        mean_a = s.mean_a, mean_b = s.mean_b, regions = s.regions, static_background = s.static_background,
        static_mean = s.static_mean,
        contrast = s.contrast, shadows = s.shadows,
        stop = stops and truth.stop_test(p, t.before and truth.joined(t.before, s, "truth_so_far") or s) or nil,
      }
    end,
  }
end

-- Returns the surface, shadows and colour that all first samples of a pixel and its neighbours agree on. `t`: results of the
-- first samples.
function truth.consensus_of(p, t)
  return agreement {
    static_background = t.static_background, static_mean = t.static_mean, contrast = t.contrast, shadows = t.shadows,
    even_within = p.even_within,
    one_shading = valued(p.shading) == "frozen", validation_share = p.validation_share,
  }
end

-- Means over all time samples, in two loops, so that fewer rays are traced. The first loop traces a few samples spread over the
-- exposure. The second loop takes the other samples; it skips a ray if all first samples agree on the result of that ray.
function truth.everywhere(p, raster)
  local every_ray, count = valued(p.mode) == "brute", valued(p.samples)
  local stops = valued(p.tolerance) > 0
  local eighth = math.max(count // 8, 8)
  local given = valued(p.first_samples)
  local few = math.min(given > 0 and given or stops and math.min(eighth, 64) or eighth, count)
  if few == count then
    return truth.shutter(p, raster, { name = "shutter", count = count, first = 0, parts = count, every_ray = every_ray })
  end
  local before = truth.shutter(p, raster, {
    name = "first", count = few, first = 0, parts = count, every_ray = every_ray, stats = not every_ray,
    probes = not every_ray and valued(p.shading) == "frozen" and count >= 4 * few, as = "truth_first",
  })
  local consensus = not every_ray and truth.consensus_of(p, before) or nil
  -- With pixel = box, the second loop runs over a list of the pixels that need further samples. With pixel = centre and
  -- frozen shading, the pass itself samples a static pixel only once.
  local has_list = consensus and valued(p.pixel) == "box"
  local more = truth.shutter(p, raster, {
    name = "shutter", count = count - few, first = few, parts = count, every_ray = every_ray, before = before,
    consensus = consensus, pixel_list = has_list and compact.pixels(consensus.more, "truth") or nil,
  })
  return truth.joined(before, more, "truth_sum")
end

return truth
