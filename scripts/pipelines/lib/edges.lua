-- SPDX-License-Identifier: MIT
-- Edge detectors: each file of passes/edge, a pass that writes `edge`. It reads what it names of what raster saw
-- (depth, normal, id, ...) and `where` (to look); anything else it reads is made by a function of `prepared`.
local pass     = require "strobe.pass"
local gradient = require "passes.canny.gradient"
local thin     = require "passes.canny.thin"

local edges = { names = pass.family "edge" }

-- Images that steps before a detector make, by detector.
local prepared = {}

-- Thresholds of strong edges are parameters of the node edge_gradient; those of weak ones are a ratio in edge_thin.
function prepared.canny(seen)
  local steepest = gradient { depth = seen.depth, normal = seen.normal, as = "edge_gradient" }.gradient
  return { ridge = thin { gradient = steepest, as = "edge_thin" }.ridge }
end

-- `where` may be nil: everywhere.
function edges.detected(name, seen, where)
  local detector = pass.member("edge", name)
  local images = prepared[name] and prepared[name](seen) or {}
  for port, image in pairs(seen) do images[port] = image end
  images.where = where
  return detector(pass.wired(detector, images, { as = "edge" })).edge
end

-- What each does and where it fails, for the menu of a pipeline. A file that is not sound (yet) is its own problem,
-- once it is chosen.
function edges.texts()
  local texts = {}
  for _, name in ipairs(edges.names) do
    local sound, detector = pcall(pass.member, "edge", name)
    if sound and pass.is_pass(detector) then
      texts[name] = ("%s. %s"):format(detector.description.doc, detector.description.fails)
    end
  end
  return texts
end

return edges
