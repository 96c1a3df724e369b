-- SPDX-License-Identifier: MIT
-- Meaning of the parameter `effort` of the pipeline `selective`, a number from 0 to 1:
--   0              a post-process blur only
--   below 0.75     rays at several times in the pixels where a gather is not certain, with more rays between two that differ
--   from 0.75 on   ground truth; at effort 1 it has 16 times `samples` time samples
local pipeline = require "strobe.pipeline"

local selective = {}

local settings = pipeline.record "settings of the effort"

local truth_from = 0.75  -- lowest effort that traces every sample
local most_parts = 256   -- largest number of scene times in one iteration

-- is_gather: true if the effort selects the post-process blur only. is_truth: true if the effort selects ground truth.
function selective.is_gather(effort) return effort == 0 end
function selective.is_truth(effort) return effort >= truth_from end

-- Number of time samples of ground truth: 16 times `samples` at effort 1. The number halves with each tenth of effort below 1.
function selective.truth_samples(effort, samples)
  return math.max(1, math.floor(16 * samples * 2 ^ (10 * (effort - 1)) + 0.5))
end

-- Settings of an effort below ground truth. The allowed error halves with each tenth of effort. The displacement between the
-- first rays of a pixel (`pace`) halves with every second tenth.
function selective.settings(effort, samples)
  local tenths = 10 * effort - 1
  local finer = math.floor(math.max(0, math.min(2, tenths / 2)))
  return settings {
    pace = 0.08 * 2 ^ (-tenths / 2),
    allowance = 0.08 * 2 ^ -tenths,
    apart_px = 2 ^ (-tenths / 2),
    hit_color = effort < 0.25 and "kept" or "shaded",
    parts = math.min(2 ^ (math.floor(math.log(samples, 2)) + finer) // 1 | 0, most_parts),  -- a power of two halves evenly
  }
end

return selective
