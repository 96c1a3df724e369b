-- SPDX-License-Identifier: MIT
-- Images that filters along the motion read and write. Each name has one meaning in every filter.
local quantised = require "passes.lib.quantised"

local blur_ports = {}

local depth = "linear view depth, metres; +inf for the sky"

local docs = {
  color    = { doc = "colour of the layer to blur, linear radiance" },
  depth    = { doc = depth },
  velocity = { doc = "displacement of the surface, px over the exposure" },
  dominant = { doc = "longest displacement that reaches each tile, px over the exposure" },
  second   = { absent = "dominant",
    doc = "displacement around each tile that differs most from the dominant displacement, px over the exposure" },
  slowest  = { absent = 0, doc = "length of the shortest displacement around each tile, px over the exposure" },

  velocity_post = { absent = "velocity", doc = "displacement at times after the raster time, px over the exposure" },
  dominant_post = { absent = "dominant",
    doc = "dominant displacement of each tile at times after the raster time, px over the exposure" },
  second_post   = { absent = "dominant_post",
    doc = "displacement around each tile that differs most from `dominant_post`, px over the exposure" },

  curve          = { absent = 0, needs = "curve",
    doc = "coefficients of the parabola or arc that the screen path follows; 0 for a straight line" },
  revealed_curve = { absent = 0, needs = "curve",
    doc = "coefficients of the parabola or arc that the screen path of the revealed surface follows; 0 for a straight line" },
  dominant_curve = { absent = 0, needs = "curve",
    doc = "coefficients of the parabola or arc that belongs to the dominant displacement; 0 for a straight line" },
  dominant_place = { absent = -1, needs = "curve",
    doc = "position of the texel that has the dominant displacement, px; -1 if unknown" },

  -- Ports of a filter of one layer, if a revealed layer lies behind that layer.
  valid            = { absent = 1, doc = "mask, above 1/2 where the layer has a surface" },
  background_depth = { absent = "depth", doc = "linear view depth of the revealed surface behind each pixel, metres" },
  background_valid = { absent = 0, doc = "mask, above 1/2 where a surface was revealed behind the pixel" },

  -- Ports of the revealed layer.
  revealed_color    = { doc = "colour of the revealed surface, linear radiance" },
  revealed_depth    = { doc = "linear view depth of the revealed surface, metres; +inf for the sky" },
  revealed_velocity = { doc = "displacement of the revealed surface, px over the exposure" },
  revealed_valid    = { doc = "mask, above 1/2 where a surface was revealed" },
  revealed_dominant = { absent = "dominant",
    doc = "dominant displacement of each tile of the revealed layer alone, px over the exposure" },
  revealed_velocity_post = { absent = "revealed_velocity",
    doc = "displacement of the revealed surface at times after the raster time, px over the exposure" },
  revealed_dominant_post = { absent = "dominant_post",
    doc = "dominant displacement of each tile of the revealed layer at times after the raster time, px over the exposure" },
}

local function reads(names, more)
  local list = {}
  for _, name in ipairs(names) do list[name] = docs[name] or error(("no filter reads '%s'"):format(name), 3) end
  for name, port in pairs(more or {}) do list[name] = port end
  return list
end

-- Returns the reads of a filter of one image: the ports that `names` lists, and the ports in `more`.
function blur_ports.of(names, more) return reads(names, more) end

-- Returns the reads of a filter of one layer, which may have a revealed layer behind it: the ports of that layer, the ports
-- that `names` lists, and the ports in `more`.
function blur_ports.of_layer(names, more)
  local all = { "color", "depth", "velocity", "dominant", "valid", "background_depth", "background_valid" }
  return reads(table.move(names, 1, #names, #all + 1, all), more)
end

-- Returns the reads of a filter of both layers at once: the ports of both layers, the ports that `names` lists, and the ports
-- in `more`.
function blur_ports.of_both(names, more)
  local all = { "color", "depth", "velocity", "dominant", "velocity_post", "dominant_post", "revealed_color",
                "revealed_depth", "revealed_velocity", "revealed_valid", "revealed_velocity_post" }
  return reads(table.move(names, 1, #names, #all + 1, all), more)
end

blur_ports.layer = { blurred = { format = quantised.color,
  doc = "blurred layer, linear radiance times alpha; alpha is below 1 only over a revealed surface" } }

-- Stand-in for the output of a filter if nothing moves: the unblurred colour.
blur_ports.no_motion = { motion = { blurred = "color" } }

blur_ports.picture = { blurred = { format = "rgba32f", doc = "blurred picture, linear radiance; alpha 1" } }

return blur_ports
