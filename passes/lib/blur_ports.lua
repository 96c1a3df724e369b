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

-- Those behind it.
for number = 2, 4 do
  local layer = ("revealed_%d_"):format(number)
  docs[layer .. "color"]    = { optional = true, doc = "linear, of the next surface behind; absent: there is none" }
  docs[layer .. "depth"]    = { optional = true, doc = depth }
  docs[layer .. "velocity"] = { optional = true, doc = displacement }
  docs[layer .. "valid"]    = { optional = true, doc = "above 1/2 where something was revealed" }
  docs[layer .. "after_velocity"] = { optional = true, doc = layer .. "velocity at times after the capture" }
  docs[layer .. "curve"] = { optional = true, needs = layer .. "curve", doc = "of its path, px; absent: lines" }
end

-- Without a surface that it holds no image of a layer is of use.
local function needing_valid(layer, names)
  for _, name in ipairs(names) do docs[layer .. name].needs = layer .. "valid" end
end
for number = 2, 4 do
  needing_valid(("revealed_%d_"):format(number), { "color", "depth", "velocity", "valid", "after_velocity" })
end

-- What an end of the exposure sees and none of the others holds, where it is then.
for _, which in ipairs { "open", "close" } do
  local layer = which .. "_"
  docs[layer .. "color"]    = { optional = true,
    doc = ("linear, of what the exposure's %s alone sees; absent: nothing"):format(which == "open" and "start" or "end") }
  docs[layer .. "depth"]    = { optional = true, doc = "its linear view depth then, metres" }
  docs[layer .. "velocity"] = { optional = true, doc = displacement }
  docs[layer .. "valid"]    = { optional = true, doc = "above 1/2 where there is any" }
  docs[layer .. "dominant"] = { optional = true, doc = "px over the exposure, per tile, of that alone" }
  local curve = layer .. "curve"
  docs[curve] = { optional = true, needs = curve, doc = "of its path, px; absent: lines" }
  docs[layer .. "dominant_curve"] = { optional = true, needs = curve, doc = "of the path of dominant, px; absent: a line" }
  docs[layer .. "dominant_place"] = { optional = true, needs = curve, doc = "px, the texel that has dominant" }
  needing_valid(layer, { "color", "depth", "velocity", "valid", "dominant" })
end

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

-- What a filter reads of further layers behind.
function blur_ports.further(names)
  local parts = { "color", "depth", "velocity", "valid", "after_velocity", "curve" }
  for number = 2, 4 do
    for _, part in ipairs(parts) do names[#names + 1] = ("revealed_%d_%s"):format(number, part) end
  end
  return names
end

-- What it reads of the ends of the exposure.
function blur_ports.ends(names)
  for _, which in ipairs { "open", "close" } do
    local parts = { "color", "depth", "velocity", "valid", "dominant", "curve", "dominant_curve", "dominant_place" }
    for _, part in ipairs(parts) do names[#names + 1] = which .. "_" .. part end
  end
  return names
end

blur_ports.layer = { blurred = { format = stored.color,
  doc = "linear, times alpha; alpha below 1 only over something revealed" } }

-- What stands in for a filter where nothing moves: what it is given.
blur_ports.still = { motion = { blurred = "color" } }

blur_ports.picture = { blurred = { format = "rgba32f", doc = "linear; alpha 1" } }

return blur_ports
