-- SPDX-License-Identifier: MIT
-- Sobol points and random numbers in [0, 1), with equal values on every machine. Experiments use them to vary many parameters
-- together (`sobol` and `random` of strobe.vary).
local sequences = {}

-- Constants of the Sobol sequence, one row for each dimension from the second on. The first number of a row is a primitive
-- polynomial, with its coefficients as bits. The initial direction numbers follow. Source: S. Joe and F. Y. Kuo, "Constructing
-- Sobol sequences with better two-dimensional projections", SIAM J. Sci. Comput. 30 (2008), the set new-joe-kuo-6.21201.
local dimensions = {
  { 3, 1 },
  { 7, 1, 3 },
  { 11, 1, 3, 1 },
  { 13, 1, 1, 1 },
  { 19, 1, 1, 3, 3 },
  { 25, 1, 3, 5, 13 },
  { 37, 1, 1, 5, 5, 17 },
  { 41, 1, 1, 5, 5, 5 },
  { 47, 1, 1, 7, 11, 19 },
  { 55, 1, 1, 5, 1, 1 },
  { 59, 1, 1, 1, 3, 11 },
  { 61, 1, 3, 5, 5, 31 },
  { 67, 1, 3, 3, 9, 7, 49 },
  { 91, 1, 1, 1, 15, 21, 21 },
  { 97, 1, 3, 1, 13, 27, 49 },
  { 103, 1, 1, 1, 15, 7, 5 },
  { 109, 1, 3, 1, 15, 13, 25 },
  { 115, 1, 1, 5, 5, 19, 61 },
  { 131, 1, 3, 7, 11, 23, 15, 103 },
  { 137, 1, 3, 7, 13, 13, 15, 69 },
  { 143, 1, 1, 3, 13, 7, 35, 63 },
  { 145, 1, 3, 5, 9, 1, 25, 53 },
  { 157, 1, 3, 1, 13, 9, 35, 107 },
}

sequences.most_dimensions = #dimensions + 1

local bits = 30

-- Returns the direction numbers of a dimension, as fixed-point fractions with `bits` bits. A coordinate of a Sobol point is the
-- exclusive or of some of these numbers.
local function directions(dimension)
  local v = {}
  if dimension == 1 then
    for i = 1, bits do v[i] = 1 << (bits - i) end
    return v
  end
  local row = dimensions[dimension - 1]
  local polynomial, degree = row[1], #row - 1
  for i = 1, math.min(degree, bits) do v[i] = row[i + 1] << (bits - i) end
  for i = degree + 1, bits do
    v[i] = v[i - degree] ~ (v[i - degree] >> degree)
    for k = 1, degree - 1 do
      if (polynomial >> (degree - k)) & 1 == 1 then v[i] = v[i] ~ v[i - k] end
    end
  end
  return v
end

-- Returns the first `count` points of the Sobol sequence in `width` dimensions. Each point is a list of numbers in [0, 1); the
-- first point is 0. The order of the points is the order of the Gray code (Antonov and Saleev 1979). Each point then follows
-- from the previous point by one exclusive or per dimension.
function sequences.sobol(count, width)
  local points, state, v = {}, {}, {}
  for d = 1, width do v[d], state[d] = directions(d), 0 end
  for n = 1, count do
    local point = {}
    for d = 1, width do point[d] = state[d] / (1 << bits) end
    points[n] = point
    local zero, rest = 1, n - 1  -- zero: position of the lowest 0 bit of n - 1; the lowest bit has position 1
    while rest & 1 == 1 do zero, rest = zero + 1, rest >> 1 end
    for d = 1, width do state[d] = state[d] ~ v[d][zero] end
  end
  return points
end

-- Returns a function that returns the next random number in [0, 1) at each call. The generator is SplitMix64 (Steele, Lea and
-- Flood 2014), started with `seed`.
function sequences.random(seed)
  local state = seed
  return function()
    state = state + 0x9e3779b97f4a7c15
    local z = state
    z = (z ~ (z >> 30)) * 0xbf58476d1ce4e5b9
    z = (z ~ (z >> 27)) * 0x94d049bb133111eb
    z = z ~ (z >> 31)
    return (z >> 11) / (1 << 53)
  end
end

return sequences
