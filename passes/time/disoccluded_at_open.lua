-- SPDX-License-Identifier: MIT
-- Moving surfaces that are visible at shutter open, but are in neither layer.
local pass        = require "strobe.pass"
local disoccluded = require "passes.lib.disoccluded"

return pass.compute(disoccluded("start", "before"))
