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
  second   = { optional = true,
    doc = "displacement around each tile that differs most from the dominant displacement, px over the exposure" },
  slowest  = { optional = true,
    doc = "length of the shortest displacement around each tile, px over the exposure; absent: the filter does not check " ..
      "whether all motion around a tile is similar" },

  velocity_post = { optional = true,
    doc = "displacement at times after the raster time, px over the exposure; absent: equal to `velocity`" },
  dominant_post = { optional = true,
    doc = "dominant displacement of each tile at times after the raster time, px over the exposure" },
  second_post   = { optional = true,
    doc = "displacement around each tile that differs most from `dominant_post`, px over the exposure" },

  curve          = { optional = true, needs = "curve",
    doc = "coefficients of the parabola or arc that the screen path follows; absent: the path is a straight line" },
  revealed_curve = { optional = true, needs = "curve",
    doc = "coefficients of the parabola or arc that the screen path of the revealed surface follows; absent: the path is a " ..
      "straight line" },
  dominant_curve = { optional = true, needs = "curve",
    doc = "coefficients of the parabola or arc that belongs to the dominant displacement; absent: the path is a straight " ..
      "line" },
  dominant_place = { optional = true, needs = "curve",
    doc = "position of the texel that has the dominant displacement, px" },

  -- Ports of a filter of one layer, if a revealed layer lies behind that layer.
  valid            = { optional = true, doc = "mask, above 1/2 where the layer has a surface; absent: everywhere" },
  background_depth = { optional = true, doc = "linear view depth of the revealed surface behind each pixel, metres" },
  background_valid = { optional = true,
    doc = "mask, above 1/2 where a surface was revealed behind the pixel; absent: nowhere" },

  -- Ports of the revealed layer.
  revealed_color    = { doc = "colour of the revealed surface, linear radiance" },
  revealed_depth    = { doc = "linear view depth of the revealed surface, metres; +inf for the sky" },
  revealed_velocity = { doc = "displacement of the revealed surface, px over the exposure" },
  revealed_valid    = { doc = "mask, above 1/2 where a surface was revealed" },
  revealed_dominant = { optional = true,
    doc = "dominant displacement of each tile of the revealed layer alone, px over the exposure" },
  revealed_velocity_post = { optional = true,
    doc = "displacement of the revealed surface at times after the raster time, px over the exposure" },
  revealed_dominant_post = { optional = true,
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
