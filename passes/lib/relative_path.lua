-- SPDX-License-Identifier: MIT
-- Parameters of the paths that the relative mask walks, so that a name means the same in each of its steps.
local param = require "strobe.param"

return {
  match = param.float { 0.25, min = 0, max = 10,
    doc = "share of the relative motion by which a background may differ" },
  margin = param.int { 1, min = 0, max = 64, unit = "px", doc = "how much farther than the relative motion to look" },
}
