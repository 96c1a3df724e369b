-- SPDX-License-Identifier: MIT
-- Moving surfaces visible at shutter open that both layers of the raster time lack.
local pass   = require "strobe.pass"
local unseen = require "passes.lib.unseen"

return pass.compute(unseen("unseen_open", "start", "before"))
