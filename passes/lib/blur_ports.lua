-- SPDX-License-Identifier: MIT
-- Images that filters along the motion read and write, so that a name means the same in each.
local stored = require "passes.lib.stored"

local blur_ports = {}

local displacement, per_tile = "px over the exposure", "px over the exposure, per tile"
local depth = "linear view depth, metres, sky = +inf"

local docs = {
  color    = { doc = "linear" },
  depth    = { doc = depth },
  velocity = { doc = displacement },
  dominant = { doc = per_tile },
  second   = { optional = true, doc = "what else moves around, px over the exposure, per tile" },
  slowest  = { optional = true,
    doc = "px over the exposure, shortest around, per tile; absent: no path for uniform motion" },

  after_velocity = { optional = true, doc = "px over the exposure, at times after the capture; absent: velocity" },
  after_dominant = { optional = true, doc = "px over the exposure, per tile, at times after the capture" },
  after_second   = { optional = true, doc = "second at times after the capture" },

  curve          = { optional = true, needs = "curve", doc = "of its path, px; absent: lines" },
  revealed_curve = { optional = true, needs = "curve", doc = "the same of what was revealed" },
  dominant_curve = { optional = true, needs = "curve", doc = "of the path of dominant, px; absent: a line" },
  dominant_place = { optional = true, needs = "curve", doc = "px, the texel that has dominant" },

  -- Of one layer, where another lies behind it.
  valid        = { optional = true, doc = "above 1/2 where the layer holds something; absent: everywhere" },
  behind_depth = { optional = true, doc = "linear view depth of what was revealed behind each pixel" },
  behind_valid = { optional = true, doc = "above 1/2 where something was; absent: nowhere" },

  -- The layer behind.
  revealed_color    = { doc = "linear" },
  revealed_depth    = { doc = depth },
  revealed_velocity = { doc = displacement },
  revealed_valid    = { doc = "above 1/2 where something was revealed" },
  revealed_dominant = { optional = true, doc = "px over the exposure, per tile, of that layer alone" },
  revealed_after_velocity = { optional = true, doc = "revealed_velocity at times after the capture" },
  revealed_after_dominant = { optional = true, doc = "revealed_dominant at times after the capture" },
}

local function reads(names, more)
  local list = {}
  for _, name in ipairs(names) do list[name] = docs[name] or error(("no filter reads '%s'"):format(name), 3) end
  for name, port in pairs(more or {}) do list[name] = port end
  return list
end

-- A filter of one picture, with what else it reads in `more`.
function blur_ports.of(names, more) return reads(names, more) end

-- A filter of one layer that another may lie behind, with what else it reads: by name, and in `more`.
function blur_ports.of_layer(names, more)
  local all = { "color", "depth", "velocity", "dominant", "valid", "behind_depth", "behind_valid" }
  return reads(table.move(names, 1, #names, #all + 1, all), more)
end

-- A filter of both layers at once.
function blur_ports.of_both(names, more)
  local all = { "color", "depth", "velocity", "dominant", "after_velocity", "after_dominant", "revealed_color",
                "revealed_depth", "revealed_velocity", "revealed_valid", "revealed_after_velocity" }
  return reads(table.move(names, 1, #names, #all + 1, all), more)
end

blur_ports.layer = { blurred = { format = stored.color,
  doc = "linear, times alpha; alpha below 1 only over something revealed" } }

-- What stands in for a filter where nothing moves: what it is given.
blur_ports.still = { motion = { blurred = "color" } }

blur_ports.picture = { blurred = { format = "rgba32f", doc = "linear; alpha 1" } }

return blur_ports
