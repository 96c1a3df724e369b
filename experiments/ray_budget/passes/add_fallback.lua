-- SPDX-License-Identifier: MIT
-- Replaces unresolved samples by their fallback estimate in pixels without rays.
local pass = require "strobe.pass"

return pass.compute {
  shader = "guessed",
  doc    = "Fallback estimate of the unresolved samples at pixels outside a mask, instead of rays",
  fails  = "Inherits the errors of the fallback estimate.",
  size   = { of = "partial" },
  reads  = {
    partial           = {
      doc = "sum of the resolved samples over the number of all samples, linear; alpha: share of resolved samples" },
    unresolved        = { uint = true, doc = "unresolved samples, one bit each" },
    fallback_estimate = { doc = "sum of the fallback estimates of unresolved samples over the number of all samples, linear" },
    mask              = { doc = "above 1/2 at pixels whose samples stay unresolved" },
  },
  writes = {
    partial_now = { format = "rgba32f",
      doc = "`partial` inside the mask; outside, `partial` plus the estimate, with alpha 1; linear" },
    unresolved_now = { format = "rg32ui", doc = "`unresolved` inside the mask; 0 outside" },
  },
  if_no = { motion = { partial_now = "partial", unresolved_now = "unresolved" } },
}
