-- SPDX-License-Identifier: MIT
-- What each pixel sees, found by a ray: where silhouettes cross a sample position, raster and rays may differ.
local pass = require "strobe.pass"

return pass.trace {
  name   = "visibility_traced",
  shader = "scene/visibility_traced",
  doc    = "Nearest triangle at each sample position, by a ray",
  writes = { hit = { format = "rgba32ui", doc = "instance + 1 (0 = sky), geometry, primitive, 0" } },
}
