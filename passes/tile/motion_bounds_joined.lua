-- SPDX-License-Identifier: MIT
-- Between which displacements all of a cell of several layers lie.
local pass          = require "strobe.pass"
local motion_bounds = require "passes.lib.motion_bounds"

return pass.compute(motion_bounds("motion_bounds_joined", true))
