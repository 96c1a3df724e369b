-- SPDX-License-Identifier: MIT
-- Composite of the raster layer and the revealed layer, per time sample.
local pass    = require "strobe.pass"
local layered = require "passes.lib.layered_composite"

return pass.compute(layered())
