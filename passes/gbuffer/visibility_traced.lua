-- SPDX-License-Identifier: MIT
-- Visible triangle of each pixel by a ray. Rasterisation and rays may differ where a silhouette crosses a sample position.
local pass = require "strobe.pass"

return pass.trace {
  doc    = "Nearest triangle at each pixel's sample position, by a ray",
  writes = { hit = { format = "rgba32ui", doc = "visible surface, by indices: instance + 1 (0 for the sky), geometry, " ..
      "triangle, 0" } },
}
