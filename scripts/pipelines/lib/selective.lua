-- SPDX-License-Identifier: MIT
-- Meaning of the parameter `effort` of the pipeline `selective`, a number from 0 to 1:
--   0              a post-process blur only
--   below 0.75     rays at several times in the pixels where a gather is not reliable; where two successive rays of a pixel
--                  differ, a further ray is traced between them
--   from 0.75 on   ground truth; at effort 1, it has 16 times `samples` time samples
local pipeline = require "strobe.pipeline"

local selective = {}

local settings = pipeline.record "settings of the effort"

local truth_from = 0.75  -- lowest effort that selects ground truth
local most_parts = 256   -- largest number of intervals between the times of rays

-- is_gather: true if the effort selects the post-process blur only. is_truth: true if the effort selects ground truth.
function selective.is_gather(effort) return effort == 0 end
function selective.is_truth(effort) return effort >= truth_from end

-- Number of time samples of ground truth: 16 times `samples` at effort 1. The number halves if the effort falls by 0.1.
function selective.truth_samples(effort, samples)
  return math.max(1, math.floor(16 * samples * 2 ^ (10 * (effort - 1)) + 0.5))
end

-- Settings for an effort above 0 and below `truth_from`:
--   pace       largest displacement between two successive first rays of a pixel, image widths; halves if effort rises by 0.2
--   allowance  error below which no ray is traced between two rays, linear radiance times fraction of the exposure; halves if
--              effort rises by 0.1
--   apart_px   largest difference of displacements that count as uniform motion, px; halves if effort rises by 0.2
--   hit_color  source of the colour of a hit: the raster texel that shows the surface ("kept"), or new shading ("shaded")
--   parts      number of intervals between the times of rays
function selective.settings(effort, samples)
  local tenths = 10 * effort - 1
  local finer = math.floor(math.max(0, math.min(2, tenths / 2)))
  return settings {
    pace = 0.08 * 2 ^ (-tenths / 2),
    allowance = 0.08 * 2 ^ -tenths,
    apart_px = 2 ^ (-tenths / 2),
    hit_color = effort < 0.25 and "kept" or "shaded",
    parts = math.min(2 ^ (math.floor(math.log(samples, 2)) + finer) // 1 | 0, most_parts),  -- halved evenly
  }
end

return selective
