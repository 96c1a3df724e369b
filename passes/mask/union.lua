-- SPDX-License-Identifier: MIT
-- Union of two masks.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Union of two masks",
  size   = { of = "first" },
  reads  = {
    first  = { doc = "first mask, above 1/2 where set" },
    second = { doc = "second mask, above 1/2 where set" },
  },
  writes = { mask = { format = "r8_unorm", doc = "union of the masks, 1 where set" } },
  fails  = "Misses a pixel only if both masks miss that pixel.",
}
