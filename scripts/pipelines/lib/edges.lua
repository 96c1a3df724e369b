-- SPDX-License-Identifier: MIT
-- Edge detectors: a name is a file of passes/edge that writes `edge` and reads the ports listed and `where` (to look).
local detectors = {
  sobel = { "depth", "normal" },
  id    = { "depth", "id" },
}

local edges = { names = {} }
for name in pairs(detectors) do edges.names[#edges.names + 1] = name end
table.sort(edges.names)

function edges.detected(name, seen, where)
  local arguments = { where = where, as = "edge" }
  for _, port in ipairs(detectors[name]) do arguments[port] = seen[port] end
  return require("passes.edge." .. name)(arguments).edge
end

return edges
