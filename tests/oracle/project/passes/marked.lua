-- SPDX-License-Identifier: MIT
-- What a pass that runs over a list does: it counts how often it ran at each pixel, and in which bin of its brightness.
local pass = require "strobe.pass"

return pass.compute {
  name   = "marked",
  shader = "marked",
  doc    = "How often it ran at each pixel, and how many of these are how bright",
  size   = { of = "color" },
  reads  = {
    color  = { doc = "linear radiance" },
    listed = { buffer = true, optional = true, doc = "the pixels that it runs for" },
  },
  dispatch_over = "listed",
  writes  = { copied = { format = "r32f", cleared = true, doc = "red of where it ran, 0 elsewhere" } },
  updates = {
    times = { format = "r32ui", doc = "how often it ran" },
    bins  = { each = 2, format = "buffer32ui", doc = "pixels with a red of i / 16 to (i + 1) / 16, for 16 numbers i" },
  },
}
