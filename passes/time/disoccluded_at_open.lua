-- SPDX-License-Identifier: MIT
-- Moving surfaces visible at shutter open that both layers of the raster time lack.
local pass        = require "strobe.pass"
local disoccluded = require "passes.lib.disoccluded"

return pass.compute(disoccluded("start", "before"))
