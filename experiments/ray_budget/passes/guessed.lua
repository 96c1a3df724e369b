-- SPDX-License-Identifier: MIT
-- A picture with open samples, of which some pixels take what was guessed.
local pass = require "strobe.pass"

return pass.compute {
  name   = "guessed",
  shader = "guessed",
  doc    = "Outside of a mask, the guess of the samples that are left open in place of rays",
  fails  = "As the guess does.",
  size   = { of = "seen" },
  reads  = {
    seen  = { doc = "linear, the samples that are explained over the number of all; alpha: their share" },
    open  = { uint = true, doc = "a bit for each of the others" },
    guess = { doc = "linear, a guess of these over the number of all" },
    mask  = { doc = "above 1/2 where they stay open" },
  },
  writes = {
    seen_now = { format = "rgba32f", doc = "as seen; outside of the mask with the guess, alpha 1" },
    open_now = { format = "rg32ui", doc = "as open; outside of the mask 0" },
  },
  without = { motion = { seen_now = "seen", open_now = "open" } },
}
