-- SPDX-License-Identifier: MIT
-- Constant mask.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Constant mask: all pixels or none",
  fails  = "If all pixels are masked, each costs a ray. If none is masked, disoccluded surfaces are missing at every " ..
    "silhouette.",
  writes = { mask = { format = "r8_unorm", doc = "mask of the ray reveal, 1 where a ray is traced" } },
  params = { everywhere = pass.bool { false, doc = "mask every pixel" } },
}
