-- SPDX-License-Identifier: MIT
-- Loops over the parts of the exposure. Each part is a whole exposure of its own: the passes of the loop draw the scene
-- at the middle of the part, and displacements are from the beginning to the end of the part. The shutter curve gives
-- all parts equal weights.
local check    = require "strobe.check"
local native   = require "strobe.native"
local node     = require "strobe.node"
local pipeline = require "strobe.pipeline"

local parts = { loop_keys = { "name", "count", "body" } }

-- Makes a loop of `count` iterations, one for each part. `name`, `count`, `body` and the result: as for pipeline.loop.
parts.loop = native.at_caller(function(place, t)
  if type(t) ~= "table" then check.fail(place, "parts.loop takes a table") end
  local problems = check.problems()
  check.keys(problems, t, parts.loop_keys, place, "the loop of parts")
  problems:raise()
  local results = pipeline.loop(t)
  node.graph.loops[#node.graph.loops].times.value = "parts"
  return results
end)

return parts
