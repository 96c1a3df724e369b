-- SPDX-License-Identifier: MIT
-- Mean over time samples. A sample shows a moving surface if one is visible, otherwise the static background.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  doc    = "Mean over all time samples: moving surfaces in the samples that show one, and the static background in the " ..
           "other samples",
  size   = { of = "moving" },
  reads  = {
    moving            = { doc = "mean colour of the visible moving surfaces, linear radiance; alpha: number of " ..
                                "samples in this mean" },
    static_background = {
      doc = "static background behind moving surfaces, linear radiance; alpha 0 where the raster layer is static: " ..
            "there, `color` is the static colour" },
    color             = { doc = "colour of the raster layer, linear radiance" },
  },
  writes = { picture = { format = "rgba32f", doc = "blurred picture, linear radiance; alpha 1" } },
  if_no = { motion = { picture = "color" }, moving_rect = { picture = "color" } },
  counters = { samples = "time samples that show a moving surface" },
  params = { samples = blur.samples { doc = "number of time samples" } },
}
