-- SPDX-License-Identifier: MIT
-- The blurred foreground over the blurred background.
local pass = require "strobe.pass"

return pass.compute {
  name   = "alpha_over",
  shader = "composite/alpha_over",
  doc    = "Front over back",
  size   = { of = "front" },
  reads  = {
    front = { doc = "linear, times alpha" },
    back  = { doc = "linear; seen where the alpha of front is below 1" },
  },
  writes = { color = { format = "rgba32f", doc = "linear; alpha 1" } },
}
