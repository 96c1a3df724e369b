-- SPDX-License-Identifier: MIT
-- The pixels that are ahead of a rank.
local pass = require "strobe.pass"

return pass.compute {
  name   = "mask_first_ranks",
  shader = "first_ranks",
  doc    = "Pixels ahead of a rank",
  fails  = "Never.",
  size   = { of = "rank" },
  reads  = {
    rank  = { uint = true, doc = "of each pixel, 0 to 4095; 0 where nothing is asked for" },
    limit = { uint = true, doc = "one texel: the first rank that is not ahead" },
  },
  writes = { mask = { format = "r8_unorm", doc = "1 at pixels ahead of it" } },
}
