-- SPDX-License-Identifier: MIT
-- Meaning of the parameter `quality` of the pipeline `adaptive`, a number from 0 to 1:
--   0              a post-process blur only
--   below 0.75     rays at several times in the pixels where a gather is not reliable; where two successive rays of a pixel
--                  differ, a further ray is traced between them
--   from 0.75 on   ground truth; at quality 1, it has 16 times `samples` time samples
local pipeline = require "strobe.pipeline"

local adaptive = {}

local settings = pipeline.record "settings of the quality"

local truth_from = 0.75  -- lowest quality that selects ground truth
local most_parts = 256   -- largest value of the setting `parts` (adaptive.settings)

-- is_gather: true if the quality selects the post-process blur only. is_truth: true if the quality selects ground truth.
function adaptive.is_gather(quality) return quality == 0 end
function adaptive.is_truth(quality) return quality >= truth_from end

-- Number of time samples of ground truth: 16 times `samples` at quality 1. The number halves if the quality falls by 0.1.
function adaptive.truth_samples(quality, samples)
  return math.max(1, math.floor(16 * samples * 2 ^ (10 * (quality - 1)) + 0.5))
end

-- Settings for a quality above 0 and below `truth_from`. First, a pixel traces rays at evenly spaced times. Then a further
-- ray subdivides an interval between two rays if the possible error of the interval is too large. Fields:
--   pace       spacing of the first rays: largest displacement of a surface from one ray to the next, image widths; halves
--              if quality rises by 0.2
--   allowance  largest error of an interval that is not subdivided: linear radiance, times the interval's fraction of the
--              exposure; halves if quality rises by 0.1
--   apart_px   largest difference of displacements that count as uniform motion, px; halves if quality rises by 0.2
--   hit_color  source of the colour of a hit: the raster texels that show the surface ("blended"), or new shading ("shaded")
--   parts      number of intervals between the possible times of rays. These `parts` + 1 times are evenly spaced
function adaptive.settings(quality, samples)
  local tenths = 10 * quality - 1
  local finer = math.floor(math.max(0, math.min(2, tenths / 2)))
  return settings {
    pace = 0.08 * 2 ^ (-tenths / 2),
    allowance = 0.08 * 2 ^ -tenths,
    apart_px = 2 ^ (-tenths / 2),
    hit_color = quality < 0.55 and "blended" or "shaded",
    parts = math.min(2 ^ (math.floor(math.log(samples, 2)) + finer) // 1 | 0, most_parts),  -- a power of two
  }
end

return adaptive
