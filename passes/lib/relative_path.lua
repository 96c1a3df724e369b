-- SPDX-License-Identifier: MIT
-- Parameters of the disocclusion mask, which follows the motion of the foreground relative to a background. Each name has one
-- meaning in every step of the mask.
local param = require "strobe.param"

return {
  match = param.float { 0.25, min = 0, max = 10,
    doc = "tolerance of the match between the displacement of a background pixel and a candidate displacement. The two may " ..
          "differ by this fraction of the relative displacement, which is the foreground's displacement minus the " ..
          "candidate; they may always differ by 1 px" },
  margin = param.int { 1, min = 0, max = 64, unit = "px",
    doc = "distance that is searched beyond the end of the foreground's motion relative to the background" },
}
