-- SPDX-License-Identifier: MIT
-- Whether tiles err as their first samples foresaw.
local pass = require "strobe.pass"
local adaptive = require "passes.lib.adaptive"

return pass.compute {
  name   = "truth_audit",
  shader = "truth/audit",
  doc    = "Holds the error of a share of the tiles, which have all samples, against what the first ones foresaw",
  size   = { of = "error" },
  reads  = {
    error      = { doc = "rgb: half the difference of the halves' means; a: number of samples" },
    tile_error = { doc = "linear radiance, of the first samples: of each tile; the larger of that and of the mean around it" },
  },
  writes = { error = { format = "rgba32f", doc = "the same" } },
  params = { tile = adaptive.tile, pilot = adaptive.pilot, order = adaptive.order, audit = adaptive.audit },
  counters = {
    audited = "tiles that had all samples, to check the others' error",
    off = "of those, tiles that err by more than twice what was foreseen",
  },
}
