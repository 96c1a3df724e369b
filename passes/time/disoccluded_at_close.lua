-- SPDX-License-Identifier: MIT
-- Moving surfaces visible at shutter close that both layers of the raster time lack.
local pass        = require "strobe.pass"
local disoccluded = require "passes.lib.disoccluded"

return pass.compute(disoccluded("end", "after"))
