-- SPDX-License-Identifier: MIT
-- Ends a loop in which no tile takes part.
local pass = require "strobe.pass"

return pass.compute {
  name   = "truth_budget_met",
  shader = "truth/budget_met",
  doc    = "Stops samples that no tile takes",
  size   = { 1, 1 },
  reads  = { rate = { doc = "one texel: samples for an error of 1; the most that any tile gets" } },
  writes = { stop = { format = "r32f", doc = "1 = stop" } },
  params = { least_budget = pass.float { 0, min = 0, max = 1e6, doc = "samples of a tile that takes part" } },
}
