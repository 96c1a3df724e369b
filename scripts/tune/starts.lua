-- SPDX-License-Identifier: MIT
-- The first `count` points of the Sobol sequence in `width` dimensions, but for the one in the corner: what `strobe tune`
-- starts from. Dimensions beyond those that the sequence has are not varied: they stay at 0.5, the middle.
local sequences = require "strobe.sequences"

local asked = ...
local width = math.min(asked.width, sequences.most_dimensions)
local points = {}
for i, point in ipairs(sequences.sobol(asked.count + 1, width)) do
  for d = width + 1, asked.width do point[d] = 0.5 end
  if i > 1 then points[i - 1] = point end
end
return points
