-- SPDX-License-Identifier: MIT
-- What the end of the exposure sees and no layer of the capture holds.
local unseen = require "passes.lib.unseen"

return unseen("unseen_close", "end", "after")
