-- SPDX-License-Identifier: MIT
-- By how much what a layer shows comes nearer or goes away within the exposure.
local pass    = require "strobe.pass"
local gbuffer = require "passes.scene.gbuffer"

return pass.compute {
  name   = "depth_change",
  shader = "scene/depth_change",
  doc    = "By how much the view depths of what a layer shows change within the exposure, from true poses",
  size   = { of = "depth" },
  scene  = true,
  reads  = {
    depth = { doc = "linear view depth, metres; sky = +inf, 0 where the layer has nothing" },
    id    = { optional = true, uint = true, doc = "instance + 1 (0 = sky); absent: that of hit" },
    hit   = { optional = true, uint = true,
      doc = "instance + 1 (0 = sky), geometry, primitive; absent: joints and morph targets are not followed" },
  },
  writes = { change = { format = "rg32f", doc = "metres over the exposure, at the pace of the part before the layer's own " ..
    "time and of that after it; of a part that there is not, as the other; sky = 0" } },
  without = { motion = { change = 0 }, depth = { change = 0 } },
  params = { displacement = gbuffer.params.displacement },
  fails  = "Depths that do not change evenly between the layer's own time and an end of the exposure are taken to: what " ..
    "turns, and what a turning camera sees.",
}
