-- SPDX-License-Identifier: MIT
-- Stream compaction: makes a list of the masked pixels, so that passes can be dispatched over this list instead of the whole
-- image.
local ballot  = require "passes.compact.ballot"
local scan    = require "passes.compact.scan"
local scatter = require "passes.compact.scatter"

local compact = {}

-- Returns the list of the pixels in `mask`. Three nodes make this list; their names begin with the text `name`.
function compact.pixels(mask, name)
  local bits = ballot { mask = mask, as = name .. "_squares" }.bits
  local rows = scan { bits = bits, as = name .. "_rows" }
  return scatter { bits = bits, before = rows.before, totals = rows.totals, as = name .. "_list" }.list
end

return compact
