-- SPDX-License-Identifier: MIT
-- Stream compaction: masked pixels as a list that passes can be dispatched over.
local ballot  = require "passes.compact.ballot"
local scan    = require "passes.compact.scan"
local scatter = require "passes.compact.scatter"

local compact = {}

-- List of the masked pixels. `name` is the prefix of the nodes.
function compact.pixels(mask, name)
  local bits = ballot { mask = mask, as = name .. "_squares" }.bits
  local rows = scan { bits = bits, as = name .. "_rows" }
  return scatter { bits = bits, before = rows.before, totals = rows.totals, as = name .. "_list" }.list
end

return compact
