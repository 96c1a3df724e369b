-- SPDX-License-Identifier: MIT
-- Lists of masked pixels, which passes run over instead of the whole picture.
local listed_squares = require "passes.list.listed_squares"
local listed_rows    = require "passes.list.listed_rows"
local listed_pixels  = require "passes.list.listed_pixels"

local lists = {}

-- The pixels of a mask. `name` begins the names of the nodes.
function lists.of(mask, name)
  local bits = listed_squares { mask = mask, as = name .. "_squares" }.bits
  local rows = listed_rows { bits = bits, as = name .. "_rows" }
  return listed_pixels { bits = bits, before = rows.before, totals = rows.totals, as = name .. "_list" }.list
end

return lists
