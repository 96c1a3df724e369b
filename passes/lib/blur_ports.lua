-- SPDX-License-Identifier: MIT
-- Images that filters along the motion read and write. Each name has one meaning in every filter.
local quantised = require "passes.lib.quantised"

local blur_ports = {}

local depth = "linear view depth, metres; +inf for the sky"

local docs = {
  color    = { doc = "colour of the layer to blur, linear radiance" },
  depth    = { doc = depth },
  velocity = { doc = "screen displacement of the surface, px over the exposure" },
  dominant = { doc = "longest displacement that can bring a surface to each tile, px over the exposure" },
  second   = { absent = "dominant",
    doc = "displacement around each tile that differs most from `dominant`, px over the exposure" },
  slowest  = { absent = 0, doc = "length of the shortest displacement around each tile, px over the exposure" },

  velocity_post = { absent = "velocity",
    doc = "screen displacement of the surface in the part of the exposure after the raster time, scaled to the length of " ..
          "the whole exposure, px" },
  dominant_post = { absent = "dominant",
    doc = "dominant displacement of each tile in the part of the exposure after the raster time, scaled to the length of " ..
          "the whole exposure, px" },
  second_post   = { absent = "dominant_post",
    doc = "displacement around each tile that differs most from `dominant_post`, px over the exposure" },

  curve          = { absent = 0, needs = "curve",
    doc = "curve of the screen path of each surface, as coefficients of a parabola or an arc; 0 for a straight line" },
  revealed_curve = { absent = 0, needs = "curve",
    doc = "curve of the screen path of each revealed surface, as coefficients of a parabola or an arc; 0 for a straight line" },
  dominant_curve = { absent = 0, needs = "curve",
    doc = "curve of the path with the dominant displacement, as coefficients of a parabola or an arc; 0 for a straight line" },
  dominant_place = { absent = -1, needs = "curve",
    doc = "position of the texel that has the dominant displacement, px; -1 if unknown" },

  -- Further ports of a filter that blurs one layer. The layer may lack a surface at some pixels (`valid`), and a revealed layer
  -- may lie behind the blurred layer (`background_depth`, `background_valid`).
  valid            = { absent = 1, doc = "mask, above 1/2 where the layer has a surface" },
  background_depth = { absent = "depth", doc = "linear view depth of the surface that a ray revealed behind each pixel, " ..
      "metres" },
  background_valid = { absent = 0, doc = "mask, above 1/2 where a ray revealed a surface behind the pixel" },

  -- Ports of the revealed layer: the surfaces that rays found behind the raster layer.
  revealed_color    = { doc = "colour of the revealed surface: the surface that a ray found behind the raster layer; linear " ..
                              "radiance" },
  revealed_depth    = { doc = "linear view depth of the surface revealed behind the raster layer, metres; +inf for the sky" },
  revealed_velocity = { doc = "screen displacement of the surface revealed behind the raster layer, px over the exposure" },
  revealed_valid    = { doc = "mask, above 1/2 where a ray revealed a surface behind the raster layer" },
  revealed_dominant = { absent = "dominant",
    doc = "dominant displacement of the surfaces revealed behind the raster layer in each tile, px over the exposure" },
  revealed_velocity_post = { absent = "revealed_velocity",
    doc = "screen displacement of the surface revealed behind the raster layer, in the part of the exposure after the " ..
          "raster time, scaled to the length of the whole exposure, px" },
  revealed_dominant_post = { absent = "dominant_post",
    doc = "dominant displacement of the surfaces revealed behind the raster layer in each tile, in the part of the " ..
          "exposure after the raster time, scaled to the length of the whole exposure, px" },
}

local function reads(names, more)
  local list = {}
  for _, name in ipairs(names) do list[name] = docs[name] or error(("blur_ports has no image '%s'"):format(name), 3) end
  for name, port in pairs(more or {}) do list[name] = port end
  return list
end

-- Returns the input ports of a filter of one image: the ports that `names` lists, and the ports in `more`.
function blur_ports.of(names, more) return reads(names, more) end

-- Returns the input ports of a filter of one layer, which may have a revealed layer behind it: the ports of that layer, the
-- ports that `names` lists, and the ports in `more`.
function blur_ports.of_layer(names, more)
  local all = { "color", "depth", "velocity", "dominant", "valid", "background_depth", "background_valid" }
  return reads(table.move(names, 1, #names, #all + 1, all), more)
end

-- Returns the input ports of a filter of both layers at once: the ports of both layers, the ports that `names` lists, and the
-- ports in `more`.
function blur_ports.of_both(names, more)
  local all = { "color", "depth", "velocity", "dominant", "velocity_post", "dominant_post", "revealed_color",
                "revealed_depth", "revealed_velocity", "revealed_valid", "revealed_velocity_post" }
  return reads(table.move(names, 1, #names, #all + 1, all), more)
end

blur_ports.layer = { blurred = { format = quantised.color,
  doc = "blurred layer, linear radiance times alpha; alpha is below 1 only at pixels with a revealed surface, which shows " ..
        "through" } }

-- Stand-in for the output of a filter if nothing moves: the unblurred colour.
blur_ports.no_motion = { motion = { blurred = "color" } }

blur_ports.picture = { blurred = { format = "rgba32f", doc = "blurred picture, linear radiance; alpha 1" } }

return blur_ports
