-- SPDX-License-Identifier: MIT
-- Fills in the pixels that a filter left out where it ran at half resolution, in some parts of the picture.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Picture whose missing pixels are the means of the surrounding pixels with even coordinates",
  fails  = "Details of less than two pixels are lost in the missing pixels.",
  size   = { of = "blurred" },
  reads  = {
    blurred = { doc = "blurred picture, linear radiance; alpha 1; pixels with even x and even y are never missing" },
    mask    = { pointwise = true, doc = "mask, above 1/2 at pixels that are not missing" },
  },
  writes = { filled = { format = "rgba32f", doc = "blurred picture without missing pixels, linear radiance; alpha 1" } },
  if_no  = { motion = { filled = "blurred" } },
}
