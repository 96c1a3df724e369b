-- SPDX-License-Identifier: MIT
-- Parameters of the disocclusion mask, which follows the motion of the foreground relative to a background. Each name has one
-- meaning in every step of the mask.
local param = require "strobe.param"

return {
  match = param.float { 0.25, min = 0, max = 10,
    doc = "largest difference between the displacement of a background pixel and a candidate displacement that still counts " ..
          "as a match, as a fraction of the foreground's displacement relative to the candidate" },
  margin = param.int { 1, min = 0, max = 64, unit = "px",
    doc = "distance that is searched beyond the end of the foreground's motion relative to the background" },
}
