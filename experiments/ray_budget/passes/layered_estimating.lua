-- SPDX-License-Identifier: MIT
-- The composite `layered`, which combines the raster layer and the revealed layer per time sample, with a further output: a
-- fallback estimate of the samples that neither layer resolves, for pixels without rays.
local pass    = require "strobe.pass"
local layered = require "passes.lib.layered_composite"

return pass.compute(layered(true))
