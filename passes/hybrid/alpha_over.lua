-- SPDX-License-Identifier: MIT
-- Composite of the blurred foreground over the blurred background, with one alpha per pixel.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Composite of the blurred foreground over the blurred background, by the alpha of the foreground, which " ..
           "is the mean coverage by the foreground over the exposure",
  fails  = "Wrong where a textured background moves under a moving silhouette: the product of mean coverage and mean " ..
           "background colour differs from the mean of their product. The error reaches 0.2, in linear radiance, even if " ..
           "both layers are perfect. With the filter `mcguire2012` the foreground is far too opaque inside its silhouettes.",
  breaks = {
    uniform    = "if the background moves with the foreground, mean coverage times mean background colour differs from the " ..
      "mean of their product over the exposure",
    converging = "with more samples the result approaches mean coverage times mean background colour, which may be farther " ..
      "from the truth",
  },
  size   = { of = "front" },
  reads  = {
    front = { doc = "blurred foreground, linear radiance times alpha" },
    back  = { doc = "blurred background, linear radiance; visible where the alpha of the foreground is below 1" },
  },
  writes = { color = { format = "rgba32f", doc = "composited picture, linear radiance; alpha 1" } },
  if_no = { motion = { color = "front" } },
}
