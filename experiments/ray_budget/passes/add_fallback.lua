-- SPDX-License-Identifier: MIT
-- Completes the pixels that the ray budget leaves without rays: adds the fallback estimate, a colour from the layers, in place
-- of the time samples that the layers do not resolve.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Replaces unresolved samples by their fallback estimate at pixels without rays",
  fails  = "Inherits the errors of the fallback estimate.",
  size   = { of = "partial" },
  reads  = {
    partial           = {
      doc = "sum of the resolved samples, divided by the number of all samples, linear; alpha: share of resolved samples" },
    unresolved        = { uint = true, doc = "unresolved samples, one bit each" },
    fallback_estimate = { doc = "sum of the fallback estimates of the unresolved samples, divided by the number of all " ..
      "samples, linear" },
    mask              = { doc = "above 1/2 at pixels with rays, whose samples stay unresolved" },
  },
  writes = {
    partial_now = { format = "rgba32f",
      doc = "colour, linear: `partial` inside the mask; outside, `partial` plus `fallback_estimate`, with alpha 1" },
    unresolved_now = { format = "rg32ui", doc = "unresolved samples, one bit each: `unresolved` inside the mask; 0 outside" },
  },
  if_no = { motion = { partial_now = "partial", unresolved_now = "unresolved" } },
}
