-- SPDX-License-Identifier: MIT
-- Displacements as a broken renderer may leave them.
local pass = require "strobe.pass"

return pass.compute {
  name   = "damage",
  shader = "damage",
  doc    = "Displacements that are no numbers, in the first columns",
  size   = { of = "velocity" },
  reads  = { velocity = { doc = "px over the exposure" } },
  writes = { velocity = { format = "rg32f", doc = "the same, damaged" } },
  fails  = "It is made to.",
}
