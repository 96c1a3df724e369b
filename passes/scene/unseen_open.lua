-- SPDX-License-Identifier: MIT
-- What the start of the exposure sees and no layer of the capture holds.
local unseen = require "passes.lib.unseen"

return unseen("unseen_open", "start", "before")
