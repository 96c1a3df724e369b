-- SPDX-License-Identifier: MIT
-- Parameters of the paths that the disocclusion mask follows. Each name has one meaning in every step of the mask.
local param = require "strobe.param"

return {
  match = param.float { 0.25, min = 0, max = 10,
    doc = "largest difference between a background pixel's displacement and a matching candidate displacement, as a " ..
      "fraction of the motion of the foreground relative to the candidate" },
  margin = param.int { 1, min = 0, max = 64, unit = "px",
    doc = "distance searched beyond the end of the foreground's motion relative to the background" },
}
