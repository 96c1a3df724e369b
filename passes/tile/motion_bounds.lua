-- SPDX-License-Identifier: MIT
-- Between which displacements all of a cell lie: what a filter must not expect to find there.
local pass          = require "strobe.pass"
local motion_bounds = require "passes.lib.motion_bounds"

return pass.compute(motion_bounds("motion_bounds", false))
