-- SPDX-License-Identifier: MIT
-- Ground truth by rays at many times. `p` has parameters of a pipeline, or plain values, under these names: mode, samples,
-- times, slices, pixel, shading, mark_regions, tolerance, first_samples, even_within, audit.
local pipeline      = require "strobe.pipeline"
local agreement     = require "passes.truth.agreement"
local joined_halves = require "passes.truth.joined_halves"
local spread        = require "passes.truth.spread"
local stop          = require "passes.truth.stop"
local trace         = require "passes.truth.trace"
local lists         = require "scripts.pipelines.lib.lists"

local truth = {}

-- The value of a setting, which is a parameter of the pipeline or a plain value.
local function valued(setting)
  local kind = type(setting)
  if kind == "number" or kind == "string" or kind == "boolean" then return setting end
  return setting()
end

-- One time sample by rays. `t.before`: results of the samples before this one. Rays about which these agree (`t.agreed`) are
-- skipped, unless `t.every_ray`.
function truth.traced_sample(p, seen, t)
  local before, agreed = t.before or {}, t.agreed or {}
  local frozen = valued(p.shading) == "frozen"
  return trace {
    hit = seen.hit, pixel = p.pixel, mark_regions = p.mark_regions, time = "sample", every_ray = t.every_ray,
    keeps_notes = t.notes, surveys = t.surveys, in_turn = valued(p.tolerance) > 0 or nil,
    audit = p.audit, as = t.as,
    sure = frozen and not t.every_ray and not t.agreed and seen.sure or nil,
    listed = t.listed, known_hit = agreed.known_hit, known_shadows = agreed.known_shadows,
    even_color = agreed.even_color,
    first_ground = before.ground, first_still = before.still, first_regions = before.regions,
    once_where_still = not t.every_ray and valued(p.pixel) == "centre" and frozen,
  }
end

function truth.stop_test(p, means)
  local blocks = spread { mean_a = means.mean_a, mean_b = means.mean_b }.spread
  return stop { spread = blocks, tolerance = p.tolerance, as = "stop" }.stop
end

function truth.joined(first, more, name)
  return joined_halves {
    first_a = first.mean_a, first_b = first.mean_b, first_regions = first.regions,
    more_a = more.mean_a, more_b = more.mean_b, more_regions = more.regions, as = name,
  }
end

-- `t.count` of `t.parts` time samples. The stop test includes the samples `t.before`, if there are any.
function truth.shutter(p, seen, t)
  local stops = valued(p.tolerance) > 0 and not t.notes
  return pipeline.loop {
    name = t.name, count = t.count, first = t.first, parts = t.parts, times = p.times, slices = p.slices,
    until_ = stops and function(results) return results.stop end or nil,
    body = function()
      local s = truth.traced_sample(p, seen, t)
      return {
        mean_a = s.mean_a, mean_b = s.mean_b, regions = s.regions, ground = s.ground, still = s.still,
        unlike = s.unlike, shadows = s.shadows,
        stop = stops and truth.stop_test(p, t.before and truth.joined(t.before, s, "truth_so_far") or s) or nil,
      }
    end,
  }
end

function truth.agreement_of(p, t)
  return agreement {
    ground = t.ground, still = t.still, unlike = t.unlike, shadows = t.shadows, even_within = p.even_within,
    one_shading = valued(p.shading) == "frozen", audit = p.audit,
  }
end

-- A few samples all over the exposure; then the others, which trace rays only where the first do not agree.
function truth.everywhere(p, seen)
  local every_ray, count = valued(p.mode) == "brute", valued(p.samples)
  local stops = valued(p.tolerance) > 0
  local eighth = math.max(count // 8, 8)
  local asked = valued(p.first_samples)
  local few = math.min(asked > 0 and asked or stops and math.min(eighth, 64) or eighth, count)
  if few == count then
    return truth.shutter(p, seen, { name = "shutter", count = count, first = 0, parts = count, every_ray = every_ray })
  end
  local before = truth.shutter(p, seen, {
    name = "first", count = few, first = 0, parts = count, every_ray = every_ray, notes = not every_ray,
    surveys = not every_ray and valued(p.shading) == "frozen" and count >= 4 * few, as = "truth_first",
  })
  local agreed = not every_ray and truth.agreement_of(p, before) or nil
  local has_list = agreed and valued(p.pixel) == "box"  -- through centres, pixels without motion are left out already
  local more = truth.shutter(p, seen, {
    name = "shutter", count = count - few, first = few, parts = count, every_ray = every_ray, before = before,
    agreed = agreed, listed = has_list and lists.of(agreed.more, "truth") or nil,
  })
  return truth.joined(before, more, "truth_sum")
end

return truth
