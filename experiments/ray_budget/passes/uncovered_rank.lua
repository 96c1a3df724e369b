-- SPDX-License-Identifier: MIT
-- Which of the pixels of a mask have most behind them that the exposure uncovers.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  name   = "mask_uncovered_rank",
  shader = "uncovered_rank",
  doc    = "Of a mask, how long what is behind each pixel is uncovered, times how much that differs from what is in front",
  fails  = "What is behind is taken to be at rest, or to move and look like what the longest motion around leads to.",
  size   = { of = "mask" },
  reads  = {
    mask     = { doc = "above 1/2 where something is to be revealed" },
    color    = { doc = "linear" },
    depth    = { doc = "linear view depth, metres; sky = +inf" },
    id       = { uint = true, doc = "instance + 1; sky = 0" },
    velocity = { doc = "px over the exposure" },
    dominant = { doc = "longest displacement that reaches each tile, px over the exposure" },
  },
  writes = { rank = { format = "r32ui", doc = "0 outside of the mask, else 1 to 4094, more where more is to be gained" } },
  without = { mask = { rank = 0 } },
  params = {
    samples = blur.samples,
    tile    = blur.tile,
    least   = pass.float { 0.001, min = 0, max = 1, doc = "gain where nothing seems to be uncovered, as a radiance" },
  },
  breaks = {
    linear = "colours decide which pixels have rays",
  },
}
