-- SPDX-License-Identifier: MIT
-- Ports and parameters that edge detectors share. Each name has one meaning in every detector.
local pass = require "strobe.pass"

local edge_ports = {}

local docs = {
  depth  = { doc = "linear view depth, metres; +inf for the sky" },
  normal = { doc = "unit normal, world space; 0 for the sky" },
  id     = { uint = true, doc = "instance index + 1; 0 for the sky" },
  where  = { absent = 1, doc = "mask, above 1/2 where edges are detected" },
}

-- Returns the input ports of a detector: the images named by the arguments, and the mask `where`.
function edge_ports.reads(...)
  local reads = { where = docs.where }
  for _, name in ipairs { ... } do
    reads[name] = docs[name] or error(("edge_ports.reads has no image '%s'; it has depth, normal and id"):format(name), 2)
  end
  return reads
end

edge_ports.edge = { format = "r8_unorm", doc = "edge mask, 1 on an edge" }

-- Output of a detector if the mask `where` is empty: no pixel is an edge.
edge_ports.nowhere = { where = { edge = 0 } }

function edge_ports.depth_threshold(default, doc)
  return pass.float { default, min = 1e-6, max = 16, doc = doc or "smallest relative depth step of an edge" }
end

-- Returns the parameters of detectors that compare depths and normals: the two thresholds, the rule that combines the depth
-- step with the normal step, and the parameters in `more`.
function edge_ports.steps(more)
  local params = {
    depth_threshold  = edge_ports.depth_threshold(0.05),
    normal_threshold = pass.float { 0.8, min = 1e-6, max = 16, doc = "smallest length of the difference of two unit normals " ..
        "at an edge" },
    combine          = pass.choice { "max", "sum", "and", default = "max",
      doc = "combination of the depth step and the normal step into one edge strength",
      values = {
        max     = "An edge is a step of depth or of the normal above its threshold. Fails by marking creases and curved " ..
                  "surfaces, which have a step of the normal without a silhouette.",
        sum     = "The two steps, each divided by its threshold, are added; an edge has a sum above 1. Fails as `max` " ..
                  "does, and also marks surfaces where each step alone is below its threshold.",
        ["and"] = "An edge is a step of both depth and normal, each above its threshold. Fails by missing silhouettes in " ..
                  "front of a parallel surface, where normals are equal.",
      } },
  }
  for name, param in pairs(more or {}) do params[name] = param end
  return params
end

-- Returns the parameters of detectors that compute gradients.
function edge_ports.gradients()
  return edge_ports.steps {
    norm = pass.choice { "l1", "l2", default = "l2", doc = "norm that gives the length of the gradient from its two components",
      values = {
        l1 = "Sum of the magnitudes of both components. Fails for diagonals: a diagonal gradient counts 41 % more than an " ..
             "equally long one along an axis.",
        l2 = "Euclidean length of the gradient, equal for all directions.",
      } },
  }
end

-- Returns the parameter `measure`, the measure of the distance of a surface from a plane.
function edge_ports.measure()
  return pass.choice { "second_difference", "distance", default = "second_difference",
    doc = "measure of a neighbouring pixel's distance from the tangent plane of the pixel's surface",
    values = {
      second_difference = "Second difference of 1/z, where z is the view depth: the sum of two opposite neighbours minus " ..
                          "twice the pixel. It is 0 on a plane, where 1/z is affine in screen space. Needs no normals. " ..
                          "Fails if one neighbour is as much nearer as the opposite one is farther, and at the border of " ..
                          "the image.",
      distance = "Distance from the neighbour's point to the plane through the pixel's point and normal. Fails at the " ..
                 "silhouettes of curved surfaces, where that plane runs along the line of sight and meets the background.",
    } }
end

return edge_ports
