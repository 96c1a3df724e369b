-- SPDX-License-Identifier: MIT
-- Where something may lie behind what was revealed that the exposure uncovers in turn.
local pass = require "strobe.pass"

return pass.compute {
  name   = "mask_moving_behind",
  shader = "mask/moving_behind",
  doc    = "Pixels where what was revealed moves on the screen, so that it may uncover something itself",
  fails  = "What rests on the screen and is left by what is before it alone uncovers nothing: none is missed. Marks too " ..
           "much: most of what is behind is never seen.",
  size   = { of = "valid" },
  scene  = true,
  reads  = {
    valid    = { doc = "above 1/2 where something was revealed" },
    id       = { uint = true, doc = "its instance + 1; sky = 0" },
    velocity = { doc = "its displacement over the exposure, px" },
  },
  writes = { mask = { format = "r8_unorm", doc = "1 where the next surface is to be revealed" } },
  without = { valid = { mask = 0 }, motion = { mask = 0 }, covered = { mask = 0 } },
}
