-- SPDX-License-Identifier: MIT
-- The blurred foreground over the blurred background.
local pass = require "strobe.pass"

return pass.compute {
  name   = "alpha_over",
  shader = "composite/alpha_over",
  doc    = "Front over back",
  fails  = "Where a textured background moves under a moving silhouette: the product of mean coverage and mean " ..
           "background is not the mean of their product (errors up to 0.2 with perfect layers). With the weights " ..
           "mcguire2012 the foreground is far too opaque inside its silhouettes.",
  breaks = {
    uniform    = "where the background moves along with what is in front the product of two means is no mean of products",
    converging = "more samples come closer to the product of two means, which may be farther from the truth",
  },
  size   = { of = "front" },
  reads  = {
    front = { doc = "linear, times alpha" },
    back  = { doc = "linear; seen where the alpha of front is below 1" },
  },
  writes = { color = { format = "rgba32f", doc = "linear; alpha 1" } },
  without = { motion = { color = "front" } },
}
