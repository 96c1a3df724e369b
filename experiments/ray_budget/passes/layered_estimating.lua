-- SPDX-License-Identifier: MIT
-- The composite `layered` with a fallback estimate of unresolved samples, for pixels that will have no ray.
local pass    = require "strobe.pass"
local layered = require "passes.lib.layered_composite"

return pass.compute(layered(true))
