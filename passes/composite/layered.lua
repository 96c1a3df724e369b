-- SPDX-License-Identifier: MIT
-- Per-time layered composite of what raster saw and what was revealed behind it.
local pass    = require "strobe.pass"
local layered = require "passes.lib.layered"

return pass.compute(layered("layered"))
