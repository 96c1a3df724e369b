-- SPDX-License-Identifier: MIT
-- Mask of the pixels that get rays: the pixels with a priority above the threshold of the ray budget.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Mask of the pixels with a priority above a threshold",
  fails  = "Does not fail: the comparison is exact.",
  size   = { of = "priority" },
  reads  = {
    priority = { uint = true, doc = "priority of each pixel, 0 to 4095; 0: no ray" },
    limit    = { uint = true, doc = "threshold, one texel: the largest priority that is not selected" },
  },
  writes = { mask = { format = "r8_unorm", doc = "1 at pixels with a priority above the threshold, otherwise 0" } },
}
