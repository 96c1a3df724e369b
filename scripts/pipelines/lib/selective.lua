-- SPDX-License-Identifier: MIT
-- What one number from 0 to 1 means: which part of a frame's work is done, and how finely.
--   0              a post-process blur, and nothing else
--   below 0.75     rays in time where a gather is not certain: first ones `pace` apart, more where they differ
--   from 0.75 on   truth, at 1 with 16 times `samples`
local pipeline = require "strobe.pipeline"

local selective = {}

local settings = pipeline.record "settings of the effort"

local truth_from = 0.75  -- effort from which every sample is traced
local most_parts = 256   -- times of the exposure at which the scene is posed at once

-- Is that the post-process alone? Is it truth?
function selective.is_gather(effort) return effort == 0 end
function selective.is_truth(effort) return effort >= truth_from end

-- Samples of truth, half as many a tenth below.
function selective.truth_samples(effort, samples)
  return math.max(1, math.floor(16 * samples * 2 ^ (10 * (effort - 1)) + 0.5))
end

-- Below truth, by tenths: what is let be halves with each, the way between first rays with every second.
function selective.settings(effort, samples)
  local tenths = 10 * effort - 1
  local finer = math.floor(math.max(0, math.min(2, tenths / 2)))
  return settings {
    pace = 0.08 * 2 ^ (-tenths / 2),
    allowance = 0.08 * 2 ^ -tenths,
    apart_px = 2 ^ (-tenths / 2),
    hit_color = effort < 0.25 and "kept" or "shaded",
    parts = math.min(2 ^ (math.floor(math.log(samples, 2)) + finer) // 1 | 0, most_parts),  -- a power of two: halved evenly
  }
end

return selective
