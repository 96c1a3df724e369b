-- SPDX-License-Identifier: MIT
-- Invalid displacements, as a broken renderer may write them.
local pass = require "strobe.pass"

return pass.compute {
  name   = "damage",
  shader = "damage",
  doc    = "Displacements with invalid values in the first eight columns",
  size   = { of = "velocity" },
  reads  = { velocity = { doc = "px over the exposure" } },
  writes = { velocity = { format = "rg32f", doc = "px over the exposure, partly invalid" } },
  fails  = "Always, by design.",
}
