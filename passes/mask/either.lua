-- SPDX-License-Identifier: MIT
-- The union of two masks.
local pass = require "strobe.pass"

return pass.compute {
  name   = "mask_either",
  shader = "mask/either",
  doc    = "Pixels that one of two masks marks",
  size   = { of = "first" },
  reads  = {
    first  = { doc = "above 1/2 where set" },
    second = { doc = "above 1/2 where set" },
  },
  writes = { mask = { format = "r8_unorm", doc = "1 where one of them is set" } },
  fails  = "Never: what the two masks miss, it misses.",
}
