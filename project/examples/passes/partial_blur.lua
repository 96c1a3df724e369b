-- SPDX-License-Identifier: MIT
-- Blend of a sharp and a blurred picture. The input `mask` may be left unwired; the blur is then kept everywhere.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Blend of a sharp and a blurred picture",
  fails  = "The sharp silhouette of a moving object stays visible within its blur.",
  size   = { of = "sharp" },
  reads  = {
    sharp   = { doc = "picture without blur, linear radiance" },
    blurred = { doc = "picture with blur, linear radiance" },
    mask    = { absent = 1, doc = "mask, above 1/2 where the blur is kept" },
  },
  writes = { color = { format = "rgba32f", doc = "blended picture, linear radiance; alpha 1" } },
  if_no  = { mask = { color = "sharp" } },
  params = {
    strength = pass.float { 0.5, min = 0, max = 1, doc = "weight of the blurred picture in the blend" },
  },
  counters = { masked = "pixels that the mask keeps sharp" },
}
