-- SPDX-License-Identifier: MIT
-- The regions by which errors are reported, from truth alone.
local pass = require "strobe.pass"

return pass.compute {
  name   = "truth_regions",
  shader = "truth/regions",
  doc    = "Where the exposure shows what is farther, was hidden, or is nearer than what the capture sees",
  size   = { of = "regions" },
  reads  = { regions = { uint = true, doc = "bits, or-ed over the time samples: 1 inner, 2 hidden, 4 outer, 8 self" } },
  writes = {
    inner  = { format = "r8_unorm", doc = "1 where some time sample sees a farther, different instance" },
    hidden = { format = "r8_unorm", doc = "1 where some time sample sees a point occluded at the capture" },
    outer  = { format = "r8_unorm", doc = "1 where some time sample sees a nearer, different instance" },
    self   = { format = "r8_unorm",
      doc = "1 where some time sample sees a point occluded at the capture, of the instance that the capture sees there" },
  },
}
