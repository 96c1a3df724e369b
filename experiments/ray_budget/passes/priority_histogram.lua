-- SPDX-License-Identifier: MIT
-- Histogram of the ray priorities of all pixels. The pass `priority_limit` reads it to compute a threshold for the ray budget.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Histogram of priorities: number of pixels with each priority",
  fails  = "Does not fail: the counts are exact.",
  size   = { 64, 64 },
  reads  = { priority = { uint = true, doc = "priority of each pixel, 0 to 4095; 0: no ray" } },
  writes = { counts = { format = "buffer32ui", doc = "entry i: number of pixels with priority i; entry 0 stays 0" } },
}
