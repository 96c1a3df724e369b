-- SPDX-License-Identifier: MIT
-- The colour averaged along each pixel's own motion over the exposure: a first pass to change.
local pass = require "strobe.pass"

return pass.compute {
  name   = "smear",
  shader = "smear",
  doc    = "Average of the colours along the pixel's own displacement over the exposure",
  fails  = "What moves is not blurred over what is at rest, and what is at rest not uncovered.",
  size   = { of = "color" },
  reads  = {
    color    = { doc = "linear" },
    velocity = { doc = "px over the exposure" },
  },
  writes = { color = { format = "rgba32f", doc = "linear" } },
  params = {
    taps = pass.int { 8, min = 1, max = 64, role = "sample_count", doc = "colours averaged" },
  },
}
