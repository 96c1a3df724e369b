-- SPDX-License-Identifier: MIT
-- What the start of the exposure sees and no layer of the capture holds.
local pass   = require "strobe.pass"
local unseen = require "passes.lib.unseen"

return pass.compute(unseen("unseen_open", "start", "before"))
