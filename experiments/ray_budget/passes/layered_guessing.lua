-- SPDX-License-Identifier: MIT
-- The composite `layered` where not every sample that it leaves open will have a ray.
local pass    = require "strobe.pass"
local layered = require "passes.lib.layered"

return pass.compute(layered("layered_guessing", true))
