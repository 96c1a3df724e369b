-- SPDX-License-Identifier: MIT
-- The gather of Jimenez 2014 at the pixels of a list.
local pass      = require "strobe.pass"
local gather    = require "passes.gather.jimenez2014"
local ports     = require "passes.lib.blur_ports"
local quantised = require "passes.lib.quantised"

return pass.compute {
  shader = "gather/jimenez2014",
  doc    = "The gather `jimenez2014` at the pixels of a list",
  fails  = "Fails as `jimenez2014` does: edges appear twice inside a silhouette, and surfaces that move across the dominant " ..
           "displacement are blurred along it.",
  size   = { of = "color" },
  reads  = ports.of_layer({ "slowest" }, {
    listed = { buffer = true, optional = true, doc = "pixels that the pass runs for" },
  }),
  dispatch_over = "listed",
  writes = { blurred = { format = quantised.color, cleared = true,
    doc = "blurred layer, linear radiance times alpha; 0 in other pixels" } },
  if_no  = ports.no_motion,
  params = { gather.params },
  counters = gather.counters,
}
