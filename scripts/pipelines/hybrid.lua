-- SPDX-License-Identifier: MIT
-- Tan, Cui and Bhojan 2020, "Hybrid MBlur", SIGGRAPH '20 Posters. Each section of the paper has a function here.
local pipeline    = require "strobe.pipeline"
local candidate   = require "passes.hybrid.displaced_position"
local range_check = require "passes.hybrid.range_check"
local reveal      = require "passes.hybrid.ray_reveal"
local alpha_over  = require "passes.hybrid.alpha_over"
local mcguire2012 = require "passes.gather.mcguire2012"
local edges       = require "scripts.pipelines.lib.edges"
local gathers     = require "scripts.pipelines.lib.gathers"
local options     = require "scripts.pipelines.lib.options"
local scene       = require "scripts.pipelines.lib.scene"
local tiles       = require "scripts.pipelines.lib.tiles"

-- Ray Mask: the pixels that trace a ray. A pixel is masked if it moves and an edge lies along its displacement. The edge
-- detector tests only candidates: a candidate moves, and a step along its displacement leads to another, farther object.
local function ray_mask(p, raster)
  local where = candidate { depth = raster.depth, id = raster.id, velocity = raster.velocity, taps = p.mask_taps }.candidate
  local edge = edges.detected(p.edge(), raster, where)
  return range_check { edge = edge, id = raster.id, velocity = raster.velocity, own_edge = p.own_edge, as = "mask" }.mask
end

-- Ray Reveal: traces one ray per masked pixel, through the foreground object, to the next object behind it.
local function ray_reveal(raster, mask)
  local found = reveal { hit = raster.hit, mask = mask }
  return scene.layer {
    color = found.color, depth = found.depth, velocity = found.velocity, id = found.id, valid = found.valid,
  }
end

-- Post-Process: blurs one layer by a gather along the longest displacements of the surrounding tiles. `background`: the layer
-- behind `layer`, which moving silhouettes of `layer` disocclude; nil: none.
local function blurred(p, layer, name, background)
  local dominant = tiles.dominant(p, layer, { prefix = name .. "_" })
  return gathers.blurred(p.weights(), gathers.images(layer, dominant, background), "gather_" .. name, p.color_format)
end

local edge_choice = { default = "sobel", doc = "edge detector that decides which pixels trace a ray", values = edges.texts(),
                      table.unpack(edges.names) }

-- Settings of the preset `text`, which follow the text of the paper to the letter.
local text = {
  edge = "sobel", own_edge = false, termination = "luminance", advance = "restart", on_cap = "last_hit",
  weights = "mcguire2012",
}
-- Settings of the preset `paper`: the settings `text`, except for two where the text of the paper is silent or contradicts the
-- paper's claims: a ray passes the whole foreground object at once, and each tap has an equal share of the exposure.
local paper = { text, advance = "instance_filter", weights = "uniform" }

return pipeline {
  doc = "Hybrid MBlur (Tan, Cui and Bhojan 2020): raster image and ray-traced background, each blurred, then composited",
  params = {
    options.blur(40),
    mask_taps    = pipeline.int { 1, min = 1, max = 64, doc = "number of positions along a pixel's displacement where the " ..
                                                           "ray mask tests for a farther object" },
    edge         = pipeline.choice(edge_choice),
    own_edge     = pipeline.bool { true,
      doc = "require that the first edge along the displacement belongs to the pixel's own instance" },
    termination  = reveal.params.termination,
    tolerance    = reveal.params.tolerance,
    luminance_of = reveal.params.luminance_of,
    same_motion  = reveal.params.same_motion,
    advance      = reveal.params.advance,
    max_layers   = reveal.params.max_layers,
    on_cap       = reveal.params.on_cap,
    weights      = pipeline.choice(gathers.choice("uniform", "weights of the taps")),
    directions   = mcguire2012.params.directions,
  },
  presets = {
    paper = { doc = "settings that make the paper's claims hold: rays ignore the foreground object, taps have equal weights",
              set = paper },
    text = { doc = "settings that follow the text of the paper to the letter", set = text },
    geometry_index = { doc = "settings of `paper`, but a ray ends at another geometry instead of another luminance, as the " ..
                             "paper proposes",
                       set = { paper, termination = "geometry" } },
  },
  default_preset = "paper",
  compare_with = "mcguire2012",
  build = function(p)
    local raster = scene.raster()
    local mask = ray_mask(p, raster)
    local revealed = ray_reveal(raster, mask)
    local front, back = blurred(p, raster, "raster", revealed), blurred(p, revealed, "revealed")
    return scene.outputs(raster, {
      color = alpha_over { front = front, back = back, as = "composite" }.color, mask = mask,
      revealed = revealed.color, revealed_depth = revealed.depth, revealed_velocity = revealed.velocity,
      revealed_id = revealed.id, revealed_valid = revealed.valid,
    })
  end,
}
