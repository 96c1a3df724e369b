-- SPDX-License-Identifier: MIT
-- Meaning of the effort, a number from 0 to 1: the kind of work of a frame, and its fineness.
--   0              a post-process blur, and nothing else
--   below 0.75     rays at several times where a gather is not certain: first ones `pace` apart, more where they differ
--   from 0.75 on   ground truth, at 1 with 16 times `samples` time samples
local pipeline = require "strobe.pipeline"

local selective = {}

local settings = pipeline.record "settings of the effort"

local truth_from = 0.75  -- lowest effort that traces every sample
local most_parts = 256   -- largest number of scene times in one iteration

-- True if the effort means the post-process alone (is_gather), or ground truth (is_truth).
function selective.is_gather(effort) return effort == 0 end
function selective.is_truth(effort) return effort >= truth_from end

-- Time samples of ground truth: 16 times `samples` at effort 1, half as many with each tenth below.
function selective.truth_samples(effort, samples)
  return math.max(1, math.floor(16 * samples * 2 ^ (10 * (effort - 1)) + 0.5))
end

-- Settings below ground truth. With each tenth of effort the error allowance halves; the distance of the first rays halves with
-- every second tenth.
function selective.settings(effort, samples)
  local tenths = 10 * effort - 1
  local finer = math.floor(math.max(0, math.min(2, tenths / 2)))
  return settings {
    pace = 0.08 * 2 ^ (-tenths / 2),
    allowance = 0.08 * 2 ^ -tenths,
    apart_px = 2 ^ (-tenths / 2),
    hit_color = effort < 0.25 and "kept" or "shaded",
    parts = math.min(2 ^ (math.floor(math.log(samples, 2)) + finer) // 1 | 0, most_parts),  -- a power of two: even halves
  }
end

return selective
