-- SPDX-License-Identifier: MIT
-- Data for an inspector of pixels: the first 16 hits of the camera's ray through one pixel. The output is not a picture
-- of the scene.
local pipeline = require "strobe.pipeline"
local hits     = require "passes.inspect.hits"

return pipeline {
  doc    = "The first 16 hits of the camera's ray through one pixel, nearest first; each texel of the outputs has " ..
           "one hit",
  kind   = "list",
  params = { pixel_x = hits.params.pixel_x, pixel_y = hits.params.pixel_y },
  build  = function()
    local found = hits {}
    return { hit = found.hit, where = found.where, velocity = found.velocity, color = found.color }
  end,
}
