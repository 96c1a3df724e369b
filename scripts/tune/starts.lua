-- SPDX-License-Identifier: MIT
-- Starting points of `strobe tune`: the first `count` points of the Sobol sequence in `width` dimensions, without the
-- origin, which is a corner of the unit cube. If `width` is larger than the number of dimensions of the sequence, the
-- coordinates of the remaining dimensions are 0.5.
local sequences = require "strobe.sequences"

local asked = ...
local width = math.min(asked.width, sequences.most_dimensions)
local points = {}
for i, point in ipairs(sequences.sobol(asked.count + 1, width)) do
  for d = width + 1, asked.width do point[d] = 0.5 end
  if i > 1 then points[i - 1] = point end
end
return points
