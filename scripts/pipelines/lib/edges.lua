-- SPDX-License-Identifier: MIT
-- Edge detectors: each file of passes/edge is a pass that writes an edge mask, `edge`. The detector may read images of the
-- raster layer (depth, normal, id, ...), the mask `where` of the pixels to test, and further images, which a function in
-- `prepared` makes.
local pass     = require "strobe.pass"
local gradient = require "passes.edge.canny.gradient"
local thin     = require "passes.edge.canny.thin"

local edges = { names = pass.family "edge" }

-- Table with the name of a detector as key and a function as value. The function computes, from the raster layer, the
-- further images that this detector reads.
local prepared = {}

-- Canny detector: the node edge_gradient has the thresholds of strong edges as parameters, and the node edge_thin has the ratio
-- of strong to weak thresholds.
function prepared.canny(raster)
  local steepest = gradient { depth = raster.depth, normal = raster.normal, as = "edge_gradient" }.gradient
  return { ridge = thin { gradient = steepest, as = "edge_thin" }.ridge }
end

-- Returns the edge mask of the detector `name`. `where`: mask of the pixels to test; nil: all pixels.
function edges.detected(name, raster, where)
  local detector = pass.member("edge", name)
  local images = prepared[name] and prepared[name](raster) or {}
  for port, image in pairs(raster) do images[port] = image end
  images.where = where
  return detector(pass.wired(detector, images, { as = "edge" })).edge
end

-- Returns a text for each detector, for a pipeline's menu: its effect and its failures. A detector file with mistakes is
-- left out here; its mistakes are reported when the detector is chosen.
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
