-- SPDX-License-Identifier: MIT
-- Which of the pixels with open samples have most to gain by rays.
local pass = require "strobe.pass"

return pass.compute {
  name   = "mask_open_rank",
  shader = "open_rank",
  doc    = "Pixels that had a ray, then those with open samples by how much a guess of them may be off",
  fails  = "Never: it compares what it is given.",
  size   = { of = "guess" },
  reads  = {
    open  = { uint = true, doc = "a bit for each sample that is left open" },
    guess = { doc = "alpha: by how much the guess of these may be off" },
    mask  = { doc = "above 1/2 at pixels that had a ray" },
  },
  writes = { rank = { format = "r32ui", doc = "4095 where a ray was, 0 where none is asked for, else 1 to 4094" } },
  without = { motion = { rank = 0 } },
  breaks = {
    linear = "colours decide which pixels have rays",
  },
}
