-- SPDX-License-Identifier: MIT
-- Bounds, per cell, of the displacements and bends of what a layer does not say truly where it is, with another layer's.
local pass        = require "strobe.pass"
local bent_bounds = require "passes.lib.bent_bounds"

return pass.compute(bent_bounds("bent_bounds_joined", true))
