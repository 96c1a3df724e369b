-- SPDX-License-Identifier: MIT
-- Edge detectors: each file of passes/edge is a pass that writes `edge`. Its reads are images of the raster layer (depth,
-- normal, id, ...), `where` (the pixels to test), and images made by a function of `prepared`.
local pass     = require "strobe.pass"
local gradient = require "passes.edge.canny.gradient"
local thin     = require "passes.edge.canny.thin"

local edges = { names = pass.family "edge" }

-- Functions that make further inputs of a detector, by detector.
local prepared = {}

-- The thresholds of strong edges are parameters of the node edge_gradient. Thresholds of weak edges are a ratio in edge_thin.
function prepared.canny(raster)
  local steepest = gradient { depth = raster.depth, normal = raster.normal, as = "edge_gradient" }.gradient
  return { ridge = thin { gradient = steepest, as = "edge_thin" }.ridge }
end

-- Detects edges in the pixels of `where`; nil: in all pixels.
function edges.detected(name, raster, where)
  local detector = pass.member("edge", name)
  local images = prepared[name] and prepared[name](raster) or {}
  for port, image in pairs(raster) do images[port] = image end
  images.where = where
  return detector(pass.wired(detector, images, { as = "edge" })).edge
end

-- The effect and the failures of each detector, for the menu of a pipeline. A file with mistakes is left out; it reports them
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
