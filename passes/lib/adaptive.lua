-- SPDX-License-Identifier: MIT
-- Parameters that the passes of adaptive truth share.
local param = require "strobe.param"

return {
  pilot   = param.int { 16, min = 2, max = 4096, doc = "samples that every pixel has, by which the rest are shared out" },
  samples = param.int { 1024, min = 1, max = 65536, role = "sample_count", doc = "time samples" },
  order   = param.float { 1, min = 0.5, max = 2, doc = "power of the number of samples by which their error falls" },
  tile    = param.int { 8, min = 1, max = 1024, unit = "px", doc = "side of a tile that has one number of samples" },
  audit   = param.float { 0.01, min = 0, max = 1,
    doc = "share of what is checked: tiles that have `samples` or more, pixels that trace what others take as known" },
}
