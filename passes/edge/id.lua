-- SPDX-License-Identifier: MIT
-- Silhouettes between instances, on their nearer side.
local pass = require "strobe.pass"

return pass.compute {
  name   = "edge_id",
  shader = "edge/id",
  doc    = "Pixels beside another instance that is farther",
  size   = { of = "depth" },
  reads  = {
    depth = { doc = "linear view depth, metres, sky = +inf" },
    id    = { uint = true, doc = "instance + 1; sky = 0" },
    where = { optional = true, doc = "above 1/2 where to look; absent: everywhere" },
  },
  writes = { edge = { format = "r8_unorm", doc = "1 on an edge" } },
}
