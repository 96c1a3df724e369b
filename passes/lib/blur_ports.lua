-- SPDX-License-Identifier: MIT
-- Images that filters along the motion read and write. Each name has one meaning in every filter.
local stored = require "passes.lib.stored"

local blur_ports = {}

local depth = "linear view depth, metres; +inf for the sky"

local docs = {
  color    = { doc = "colour of the layer to blur, linear radiance" },
  depth    = { doc = depth },
  velocity = { doc = "displacement of the surface, px over the exposure" },
  dominant = { doc = "longest displacement that reaches each tile, px over the exposure" },
  second   = { optional = true,
    doc = "displacement around each tile that differs most from the dominant one, px over the exposure" },
  slowest  = { optional = true,
    doc = "length of the shortest displacement around each tile, px over the exposure; absent: uniform motion is not tested" },

  after_velocity = { optional = true,
    doc = "displacement at times after the raster time, px over the exposure; absent: equal to `velocity`" },
  after_dominant = { optional = true,
    doc = "dominant displacement of each tile at times after the raster time, px over the exposure" },
  after_second   = { optional = true,
    doc = "displacement around each tile that differs most from `after_dominant`, px over the exposure" },

  curve          = { optional = true, needs = "curve", doc = "curve of the screen path, px; absent: paths are straight lines" },
  revealed_curve = { optional = true, needs = "curve",
    doc = "curve of the screen path of the revealed surface, px; absent: paths are straight lines" },
  dominant_curve = { optional = true, needs = "curve",
    doc = "curve of the path of the dominant displacement, px; absent: the path is a straight line" },
  dominant_place = { optional = true, needs = "curve", doc = "texel that has the dominant displacement, px" },

  -- Ports of one layer in front of a revealed layer.
  valid        = { optional = true, doc = "mask, above 1/2 where the layer has a surface; absent: everywhere" },
  behind_depth = { optional = true, doc = "linear view depth of the revealed surface behind each pixel, metres" },
  behind_valid = { optional = true, doc = "mask, above 1/2 where a surface was revealed behind the pixel; absent: nowhere" },

  -- Ports of the revealed layer.
  revealed_color    = { doc = "colour of the revealed surface, linear radiance" },
  revealed_depth    = { doc = "linear view depth of the revealed surface, metres; +inf for the sky" },
  revealed_velocity = { doc = "displacement of the revealed surface, px over the exposure" },
  revealed_valid    = { doc = "mask, above 1/2 where a surface was revealed" },
  revealed_dominant = { optional = true,
    doc = "dominant displacement of each tile of the revealed layer alone, px over the exposure" },
  revealed_after_velocity = { optional = true,
    doc = "displacement of the revealed surface at times after the raster time, px over the exposure" },
  revealed_after_dominant = { optional = true,
    doc = "dominant displacement of each tile of the revealed layer at times after the raster time, px over the exposure" },
}

local function reads(names, more)
  local list = {}
  for _, name in ipairs(names) do list[name] = docs[name] or error(("no filter reads '%s'"):format(name), 3) end
  for name, port in pairs(more or {}) do list[name] = port end
  return list
end

-- Reads of a filter of one image: the named ports and the ports in `more`.
function blur_ports.of(names, more) return reads(names, more) end

-- Reads of a filter of one layer that may have a revealed layer behind it: its own ports, the named ports and those in `more`.
function blur_ports.of_layer(names, more)
  local all = { "color", "depth", "velocity", "dominant", "valid", "behind_depth", "behind_valid" }
  return reads(table.move(names, 1, #names, #all + 1, all), more)
end

-- Reads of a filter of both layers at once: their ports, the named ports and those in `more`.
function blur_ports.of_both(names, more)
  local all = { "color", "depth", "velocity", "dominant", "after_velocity", "after_dominant", "revealed_color",
                "revealed_depth", "revealed_velocity", "revealed_valid", "revealed_after_velocity" }
  return reads(table.move(names, 1, #names, #all + 1, all), more)
end

blur_ports.layer = { blurred = { format = stored.color,
  doc = "blurred layer, linear radiance times alpha; alpha is below 1 only over a revealed surface" } }

-- Stand-in for the output of a filter if nothing moves: the unblurred colour.
blur_ports.still = { motion = { blurred = "color" } }

blur_ports.picture = { blurred = { format = "rgba32f", doc = "blurred picture, linear radiance; alpha 1" } }

return blur_ports
