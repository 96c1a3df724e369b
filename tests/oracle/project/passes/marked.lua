-- SPDX-License-Identifier: MIT
-- A pass over a list of pixels that counts its runs at each pixel and in each brightness bin.
local pass = require "strobe.pass"

return pass.compute {
  name   = "marked",
  shader = "marked",
  doc    = "Number of runs at each pixel and in each brightness bin",
  size   = { of = "color" },
  reads  = {
    color  = { doc = "linear radiance" },
    listed = { buffer = true, optional = true, doc = "pixels of the dispatch" },
  },
  dispatch_over = "listed",
  writes  = { copied = { format = "r32f", cleared = true, doc = "red channel of the listed pixels, 0 elsewhere" } },
  updates = {
    times = { format = "r32ui", doc = "number of runs" },
    bins  = { each = 2, format = "buffer32ui", doc = "pixels with a red of i / 16 to (i + 1) / 16, i from 0 to 15" },
  },
}
