-- SPDX-License-Identifier: MIT
-- What each pixel sees of what moves, where the rest is known from the capture.
local pass = require "strobe.pass"

return pass.raster {
  name   = "visibility_moving",
  shader = "scene/visibility",
  doc    = "Nearest triangle at each sample position; before a camera that stands still, of what moves alone",
  writes = { hit = { format = "rgba32ui", doc = "instance + 1 (0 = sky, or what is at rest), geometry, primitive, 0" } },
  params = {
    only_moving = pass.bool { true, role = "moving_alone", doc = "leave out what is at rest, before a camera at rest" },
  },
  fails  = "What moves and is hidden by what is at rest is seen: whoever reads it has to ask the capture.",
}
