-- SPDX-License-Identifier: MIT
-- One time sample of ground truth that raster has drawn, added to two interleaved halves; repeated over the shutter by
-- a loop.
local pass = require "strobe.pass"

local function half(which)
  return { format = "rgba32f", doc = "rgb: mean of the samples of " .. which .. " iterations, linear; a: their number" }
end

return pass.compute {
  name    = "truth_accumulate",
  shader  = "truth/accumulate",
  doc     = "Adds a picture to one of two halves of the time samples",
  size    = { of = "color" },
  reads   = { color = { doc = "linear, of one time" } },
  updates = { mean_a = half "even", mean_b = half "odd" },
}
