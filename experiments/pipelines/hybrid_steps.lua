-- SPDX-License-Identifier: MIT
-- The steps of the pipelines hybrid and hybrid_layered (mask, rays, composite) in any combination, for experiments that change
-- one step and keep the others.
local pass        = require "strobe.pass"
local pipeline    = require "strobe.pipeline"
local displaced_position = require "passes.hybrid.displaced_position"
local constant    = require "passes.mask.constant"
local moving      = require "passes.mask.moving"
local range_check = require "passes.hybrid.range_check"
local layered     = require "passes.layered.layered_composite"
local alpha_over  = require "passes.hybrid.alpha_over"
local in_gather   = require "passes.layered.in_gather"
local reveal      = require "passes.hybrid.ray_reveal"
local mcguire2012 = require "passes.gather.mcguire2012"
local edges       = require "scripts.pipelines.lib.edges"
local gathers     = require "scripts.pipelines.lib.gathers"
local layers      = require "scripts.pipelines.lib.layers"
local options     = require "scripts.pipelines.lib.options"
local paths       = require "scripts.pipelines.lib.paths"
local scene       = require "scripts.pipelines.lib.scene"
local tiles       = require "scripts.pipelines.lib.tiles"

local masks = { disocclusion = function(_, raster) return layers.disocclusion_mask(raster) end }

function masks.none() return constant { everywhere = false, as = "mask" }.mask end
function masks.all() return constant { everywhere = true, as = "mask" }.mask end

function masks.moving(p, raster)
  local dominant = tiles.dominant(p, raster, { prefix = "mask_" }).dominant
  return moving { velocity = raster.velocity, dominant = dominant, as = "mask" }.mask
end

function masks.paper(p, raster)
  local where = displaced_position {
    depth = raster.depth, id = raster.id, velocity = raster.velocity, taps = p.mask_taps,
  }.candidate
  local edge = edges.detected(p.edge(), raster, where)
  return range_check { edge = edge, id = raster.id, velocity = raster.velocity, own_edge = p.own_edge, as = "mask" }.mask
end

-- Blurs the raster layer and the revealed layer separately, and returns both as inputs of the composite alpha_over.
local function blurred(p, raster, revealed)
  local both = p.tiles() == "union" and tiles.dominant(p, raster, { extra = revealed }) or nil
  local function blur(layer, name, background)
    local dominant = both or tiles.dominant(p, layer, { prefix = name .. "_" })
    return gathers.blurred(p.weights(), gathers.images(layer, dominant, background), "gather_" .. name, p.color_format)
  end
  return { front = blur(raster, "raster", revealed), back = blur(revealed, "revealed") }
end

local edge_choice = { default = "sobel", doc = "edge detector of the mask `paper`", table.unpack(edges.names) }

local composites = { alpha_over = alpha_over, in_gather = in_gather, layered = layered }

return pipeline {
  doc = "The steps of hybrid and hybrid_layered in any combination",
  params = {
    options.blur(40),
    mask = pipeline.choice { "disocclusion", "paper", "moving", "all", "none", default = "disocclusion",
      doc = "pixels with a ray that reveals the background",
      values = {
        disocclusion = "The disocclusion mask, as in hybrid_layered.",
        paper  = "The published ray mask, as in hybrid.",
        moving = "Every pixel that moves or that a moving surface may cover.",
        all    = "Every pixel.",
        none   = "No pixel.",
      } },
    mask_taps    = pipeline.int { 1, min = 1, max = 64, doc = "number of positions along the displacement that the mask " ..
      "`paper` tests" },
    edge         = pipeline.choice(edge_choice),
    own_edge     = pipeline.bool { true, doc = "the range check of the mask `paper` accepts an edge only if it belongs to " ..
      "the pixel's instance" },
    termination  = reveal.params.termination,
    tolerance    = reveal.params.tolerance,
    luminance_of = reveal.params.luminance_of,
    same_motion  = reveal.params.same_motion,
    advance      = reveal.params.advance,
    max_layers   = reveal.params.max_layers,
    on_cap       = reveal.params.on_cap,
    composite    = pipeline.choice { "alpha_over", "in_gather", "layered", default = "layered",
      doc = "composite of the two layers" },
    tiles        = pipeline.choice { "union", "separate", default = "union", doc = "dominant displacement of a tile",
      values = { union = "The longest displacement of both layers.", separate = "One for each layer, as published." } },
    weights      = pipeline.choice(gathers.choice("uniform", "of the taps, under composite = alpha_over")),
    directions   = mcguire2012.params.directions,
    range        = paths.range,
    trajectory   = layered.params.trajectory,
  },
  compare_with = "mcguire2012",
  build = function(p)
    local raster = scene.raster()
    local moved = paths.split(p, raster, "segments")
    local mask = paths.mask(p, moved, masks[p.mask()])
    local found = layers.revealed(raster, mask, p.mask() == "disocclusion" and "moving_rect" or nil)
    local revealed = paths.split(p, layers.of(found), "revealed_segments")
    local composite = composites[p.composite()]
    paths.require_curves(p, composite, "composite = " .. p.composite())
    local apart = pass.reads(composite, "front")
    if not apart then layers.add_curves(p, moved, revealed) end
    local images = apart and blurred(p, moved, revealed) or
      layers.images(p, moved, revealed, composite, p.tiles() == "separate")
    local made = composite(pass.wired(composite, images, { as = "composite" }))
    return scene.outputs(raster, {
      color = apart and made.color or made.blurred, mask = mask,
      revealed = found.color, revealed_depth = found.depth, revealed_velocity = found.velocity,
      revealed_id = found.id, revealed_valid = found.valid,
    })
  end,
}
