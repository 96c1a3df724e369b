-- SPDX-License-Identifier: MIT
-- Composite of the raster layer and the revealed layer, per time sample.
local pass    = require "strobe.pass"
local layered = require "passes.lib.layered"

return pass.compute(layered("layered"))
