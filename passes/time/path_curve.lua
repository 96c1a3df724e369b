-- SPDX-License-Identifier: MIT
-- Curved screen paths over the exposure.
local pass     = require "strobe.pass"
local blur     = require "passes.lib.blur"
local followed = require "passes.lib.followed"

local none = { curve = 0 }

return pass.compute {
  doc    = "Parabolas or arcs fitted to the screen paths of a layer's surfaces, through true poses within the exposure",
  size   = { of = "depth" },
  scene  = true,
  reads  = followed,
  writes = {
    curve = { format = "rgba32f",
      doc = "xy: offset b of the curve, at mid-exposure, from the straight line between its ends, px. At the fraction u of " ..
            "the exposure, the offset of a parabola is 4 u (1 - u) b. zw, for arcs only: over the exposure, the distance " ..
            "from the centre of the arc grows by the factor exp(z), and the arc turns by w radians about this centre" },
  },
  if_no = { motion = none, curves = none, depth = none },
  params = { trajectory = blur.trajectory },
  fails  = "Parabolas fail if the object rotates by more than a sixth of a turn within the exposure. Arcs fail beyond one " ..
           "and a quarter turns, and for circles seen obliquely.",
}
