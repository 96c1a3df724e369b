-- SPDX-License-Identifier: MIT
-- Starting points of `strobe tune`: the first `count` points of the Sobol sequence in `width` dimensions. The point 0, a corner
-- of the cube, is left out. If `width` is larger than the number of dimensions of the sequence, the other coordinates of each
-- point are 0.5.
local sequences = require "strobe.sequences"

local asked = ...
local width = math.min(asked.width, sequences.most_dimensions)
local points = {}
for i, point in ipairs(sequences.sobol(asked.count + 1, width)) do
  for d = width + 1, asked.width do point[d] = 0.5 end
  if i > 1 then points[i - 1] = point end
end
return points
