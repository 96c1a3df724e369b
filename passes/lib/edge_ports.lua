-- SPDX-License-Identifier: MIT
-- Images and parameters that edge detectors share, so that a name means the same in each.
local pass = require "strobe.pass"

local edge_ports = {}

local docs = {
  depth  = { doc = "linear view depth, metres, sky = +inf" },
  normal = { doc = "unit, world space; sky = 0" },
  id     = { uint = true, doc = "instance + 1; sky = 0" },
  where  = { optional = true, doc = "above 1/2 where to look; absent: everywhere" },
}

-- What a detector reads: those named, and where to look.
function edge_ports.reads(...)
  local reads = { where = docs.where }
  for _, name in ipairs { ... } do
    reads[name] = docs[name] or error(("a detector reads depth, normal or id, not '%s'"):format(name), 2)
  end
  return reads
end

edge_ports.edge = { format = "r8_unorm", doc = "1 on an edge" }

-- What stands in for a detector that is to look nowhere.
edge_ports.nowhere = { where = { edge = 0 } }

function edge_ports.depth_threshold(default, doc)
  return pass.float { default, min = 1e-6, max = 16, doc = doc or "relative depth step of an edge" }
end

-- Thresholds of both steps and how they count together, and those of `more`.
function edge_ports.steps(more)
  local params = {
    depth_threshold  = edge_ports.depth_threshold(0.05),
    normal_threshold = pass.float { 0.8, min = 1e-6, max = 16, doc = "length of the normal step of an edge" },
    combine          = pass.choice { "max", "sum", "and", default = "max",
      doc = "either, both added, or both at once",
      values = {
        max     = "A step of depth or of normal is an edge by itself. Fails when either alone says nothing of a " ..
                  "silhouette: creases and curved surfaces are marked.",
        sum     = "Both steps count together, each as a share of its threshold. Fails as max does, on more surfaces.",
        ["and"] = "Depth and normal must both step. Fails at silhouettes in front of a parallel surface, where " ..
                  "normals are equal: they are missed.",
      } },
  }
  for name, param in pairs(more or {}) do params[name] = param end
  return params
end

-- The same for gradients.
function edge_ports.gradients()
  return edge_ports.steps {
    norm = pass.choice { "l1", "l2", default = "l2", doc = "how the gradients in both directions are combined",
      values = {
        l1 = "Their lengths are added. Fails to treat directions alike: a diagonal gradient counts 41 % more.",
        l2 = "The length of the vector they make.",
      } },
  }
end

-- How far a surface leaves a plane.
function edge_ports.measure()
  return pass.choice { "second_difference", "distance", default = "second_difference",
    doc = "how far a neighbour is off the plane",
    values = {
      second_difference = "By depth alone: 1/z is affine on a plane, so its second difference is 0. Fails when both " ..
                          "neighbours of a pixel are as much nearer as farther, and at the picture's border.",
      distance = "From the neighbour's point to the plane through the pixel that its normal tells. Fails at the " ..
                 "silhouettes of curved surfaces, where that plane runs along the line of sight and meets what is " ..
                 "behind.",
    } }
end

return edge_ports
