-- SPDX-License-Identifier: MIT
-- Ray priority of pixels with time samples that the layers do not resolve: the expected gain of rays for these samples, which
-- is the uncertainty of the estimate used without rays.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Priority of pixels: first pixels that have a ray, then pixels with unresolved samples, by the uncertainty of " ..
    "their fallback estimate",
  fails = "The order is only as good as the uncertainty that `fallback_estimate` stores.",
  size  = { of = "fallback_estimate" },
  reads = {
    unresolved        = { uint = true, doc = "unresolved samples, one bit each" },
    fallback_estimate = { doc = "alpha: uncertainty of the fallback estimate, radiance" },
    mask              = { doc = "above 1/2 at pixels that already have a ray" },
  },
  writes = { priority = { format = "r32ui", doc = "priority: 4095 at pixels with a ray, 0 at pixels without unresolved " ..
    "samples, otherwise 1 to 4094" } },
  if_no = { motion = { priority = 0 } },
  breaks = {
    linear = "colours decide which pixels have rays",
  },
}
