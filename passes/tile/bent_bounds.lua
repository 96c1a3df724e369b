-- SPDX-License-Identifier: MIT
-- Bounds, per cell, of the displacements of what a layer does not say truly where it is, and of their bends.
local pass        = require "strobe.pass"
local bent_bounds = require "passes.lib.bent_bounds"

return pass.compute(bent_bounds("bent_bounds", false))
