-- SPDX-License-Identifier: MIT
-- Constant mask of all pixels or none.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Constant mask for the pass `ray_reveal`: all pixels or none",
  fails  = "If all pixels are masked, each pixel costs a ray. If no pixel is masked, disoccluded surfaces are missing at " ..
           "every silhouette.",
  writes = { mask = { format = "r8_unorm", doc = "mask for the pass `ray_reveal`: 1 where a ray to the background is " ..
      "traced, otherwise 0" } },
  params = { everywhere = pass.bool { false, doc = "mask every pixel; off: mask no pixel" } },
}
