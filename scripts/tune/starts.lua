-- SPDX-License-Identifier: MIT
-- Starting points of `strobe tune`: the first `count` points of the Sobol sequence in `width` dimensions, without the point in
-- the corner. Dimensions beyond the dimensions of the sequence are not varied: they stay at 0.5, the middle.
local sequences = require "strobe.sequences"

local asked = ...
local width = math.min(asked.width, sequences.most_dimensions)
local points = {}
for i, point in ipairs(sequences.sobol(asked.count + 1, width)) do
  for d = width + 1, asked.width do point[d] = 0.5 end
  if i > 1 then points[i - 1] = point end
end
return points
