-- SPDX-License-Identifier: MIT
-- The two-sided split of a layer's motion: its displacements before and after the capture.
local pass   = require "strobe.pass"
local stored = require "passes.lib.stored"

return pass.compute {
  name   = "halves",
  shader = "scene/halves",
  doc    = "Displacements of a layer in the parts of the exposure before and after the capture, from true poses",
  size   = { of = "velocity" },
  scene  = true,
  reads  = {
    depth    = { doc = "linear view depth, metres; sky = +inf, 0 where the layer has nothing" },
    id       = { uint = true, doc = "instance + 1 (0 = sky)" },
    velocity = { doc = "displacement over the exposure, px" },
  },
  writes = {
    before = { format = stored.velocity, doc = "px over the exposure at the pace of the part before the capture; if it has " ..
      "none, as after it" },
    after  = { format = stored.velocity, doc = "px over the exposure at the pace of the part after the capture; if it has " ..
      "none, as before it" },
  },
  params = { velocity_format = stored.velocity_format },
  counters = { velocity_clamped = stored.counters.velocity_clamped },
  fails  = "Motion that bends elsewhere than at the capture is still taken for straight lines.",
}
