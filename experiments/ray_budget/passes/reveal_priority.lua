-- SPDX-License-Identifier: MIT
-- Ray priority of the masked pixels: the expected gain of a ray that reveals the background, which is how much the colour of
-- the pixel is expected to change.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  doc    = "Priority of masked pixels: mean over the exposure of the difference of visible background and foreground",
  fails  = "Assumes that the background is static, or moves with the dominant displacement of the tile.",
  size   = { of = "mask" },
  reads  = {
    mask     = { doc = "above 1/2 at pixels whose background is to be revealed" },
    color    = { doc = "colour, linear" },
    depth    = { doc = "linear view depth, metres; sky = +inf" },
    id       = { uint = true, doc = "instance + 1; sky = 0" },
    velocity = { doc = "displacement over the exposure, px" },
    dominant = { doc = "longest displacement that reaches each tile, px over the exposure" },
  },
  writes = { priority = { format = "r32ui", doc = "priority: 0 outside the mask, otherwise 1 to 4094, larger for a larger " ..
    "expected gain" } },
  if_no = { mask = { priority = 0 } },
  params = {
    samples = blur.samples,
    tile    = blur.tile,
    least   = pass.float { 0.001, min = 0, max = 1, doc = "smallest expected gain of a ray at a masked pixel, radiance" },
  },
  breaks = {
    linear = "colours decide which pixels have rays",
  },
}
