-- SPDX-License-Identifier: MIT
-- The motion blur of Blender's renderer EEVEE, for any anchor (position of the exposure relative to the raster time). Written
-- after the Blender Manual, "EEVEE, Render Settings, Motion Blur"
-- (https://docs.blender.org/manual/en/4.3/render/eevee/render_settings/motion_blur.html): an accumulation buffer with few time
-- steps (Haeberli and Akeley 1990), whose gaps a post-process blur fills. The scene is evaluated anew at each step.
local pass       = require "strobe.pass"
local parts      = require "strobe.parts"
local pipeline   = require "strobe.pipeline"
local gather     = require "passes.gather.guertin2014"
local gbuffer    = require "passes.gbuffer.gbuffer"
local visibility = require "passes.gbuffer.visibility"
local accumulate = require "passes.truth.accumulate"
local mean       = require "passes.truth.mean"
local gathers    = require "scripts.pipelines.lib.gathers"
local options    = require "scripts.pipelines.lib.options"
local scene      = require "scripts.pipelines.lib.scene"
local tiles      = require "scripts.pipelines.lib.tiles"

local snapped = "the rasteriser snaps vertices to 1/256 px, so that a silhouette may cross the centre of a pixel"

-- Returns the picture of one step. `raster`: the raster layer in the middle of the step; its colours are blurred over the
-- step's part of the exposure.
local function blurred(p, raster)
  local weights = pass.member("gather", p.weights())
  local around = tiles.dominant(p, raster, { second = p.directions() == "two" and pass.reads(weights, "second") })
  local images = gathers.images(raster, around)
  if pass.reads(weights, "slowest") then images.slowest = tiles.slowest(raster, around) end
  return gathers.blurred(p.weights(), images, "gather")
end

-- Depth, normal, ids and displacement (over the whole exposure) of the surfaces that are visible at the raster time.
local function raster_layer()
  return gbuffer { hit = visibility { as = "raster_visibility" }.hit, as = "raster_gbuffer" }
end

return pipeline {
  doc = "Blender EEVEE: the exposure is divided into steps; the scene is drawn in the middle of each step and blurred over " ..
        "the step, and the pictures are averaged",
  breaks = { mirrored = snapped, scaled = snapped },
  params = {
    options.blur(40),
    steps = pipeline.int { 4, min = 1, max = 64,
      doc = "number of parts of equal weight that the exposure is divided into; the scene is drawn and shaded once " ..
            "for each part. 1: a post-process blur of the image at the middle of the exposure. Many: an " ..
            "accumulation buffer" },
    weights    = pipeline.choice(gathers.choice("guertin2014", "weights of the taps in the blur of a step")),
    directions = gather.params.directions,
  },
  build = function(p)
    if p.limit() == 0 then  -- limit = 0 turns the blur off, so one step, at the raster time, is enough
      local sharp = scene.raster()
      return scene.outputs(sharp, { color = blurred(p, sharp) })
    end
    local raster = raster_layer()
    local halves = parts.loop { name = "steps", count = p.steps, body = function()
      local sum = accumulate { color = blurred(p, scene.raster()) }
      return { mean_a = sum.mean_a, mean_b = sum.mean_b }
    end }
    return scene.outputs(raster, { color = mean { mean_a = halves.mean_a, mean_b = halves.mean_b }.color })
  end,
}
