-- SPDX-License-Identifier: MIT
-- The pipeline ue4 with four changes, after public pages on Unreal Engine 5. Half resolution and a second direction
-- follow the console variables r.MotionBlur.HalfResGather and r.MotionBlur.Directions
-- (https://indxzero.github.io/ue544cvarwiki/articles/r.motionblur.halfresgather). Cheap taps and displacements of the
-- nearest surface follow https://howuerenderacube.super.site/motion-blur. Details that these pages leave open are
-- choices of this pipeline (docs/methods.md). Written without the source code of Unreal Engine.
local pass     = require "strobe.pass"
local pipeline = require "strobe.pipeline"
local gather   = require "passes.gather.jimenez2014"
local half_fill = require "passes.filter.half_fill"
local half_grid = require "passes.filter.half_grid"
local listed_gather    = require "passes.filter.jimenez2014_listed"
local nearest_velocity = require "passes.filter.nearest_velocity"
local neighbour_min    = require "passes.tile.neighbour_min"
local tile_min         = require "passes.tile.tile_min"
local mean     = require "passes.truth.mean"
local compact  = require "scripts.pipelines.lib.compact"
local gathers  = require "scripts.pipelines.lib.gathers"
local options  = require "scripts.pipelines.lib.options"
local scene    = require "scripts.pipelines.lib.scene"
local tiles    = require "scripts.pipelines.lib.tiles"

local on_grid = "at half resolution, the filter computes the pixels with even coordinates of the picture"
local between = "at half resolution, pixels between computed pixels are their means"
local alike = "beside a silhouette, taps on both sides have the nearer surface's displacement, so that rounding decides " ..
  "which tap is faster"

-- The raster layer with the displacements that the filter reads.
local function flattened(p, raster)
  if not p.nearest_depth() then return raster end
  local nearest = nearest_velocity { velocity = raster.velocity, depth = raster.depth }.nearest
  return scene.layer { color = raster.color, depth = raster.depth, velocity = nearest }
end

-- Blurs along the displacement `images.dominant` of each tile. `listed`: list of the pixels to compute; nil: all.
local function blurred(images, name, listed)
  if not listed then return gathers.blurred("jimenez2014", images, name) end
  return listed_gather(pass.wired(listed_gather, images, { listed = listed, as = name, color_format = "fp32" })).blurred
end

return pipeline {
  doc = "Stand-in for the blur of Unreal Engine 5: `ue4` with a gather at half resolution under heavy motion, an " ..
        "optional second direction, taps with equal weights in uniform motion, and displacements of the nearest " ..
        "surface",
  params = {
    options.blur(16),
    mirror = gather.params.mirror,
    half_resolution = pipeline.bool { true,
      doc = "in tiles whose shortest displacement is at least `heavy_motion`, gather at one pixel of each 2x2 " ..
            "pixels and interpolate the other three",
      breaks = { ["true"] = { mirrored = on_grid, shifted = on_grid, uniform = between } } },
    heavy_motion = half_grid.params.heavy_motion,
    directions = pipeline.choice { "one", "two", default = "one",
      doc = "number of directions in the image along which the filter takes taps",
      values = {
        one = "All taps along the dominant displacement. Fails where surfaces move across it: they are blurred along it.",
        two = "Mean of two gathers: along the dominant displacement, and along the displacement around the tile that " ..
              "differs most from it. Fails where two motions meet: half of each surface's blur is along the other motion.",
      } },
    cheap = pipeline.bool { true,
      doc = "use equal weights for all taps where the shortest displacement around a pixel is nearly as long as the " ..
            "dominant displacement" },
    nearest_depth = pipeline.bool { true,
      doc = "replace the displacement of each pixel by the displacement of the nearest surface in 3x3 pixels",
      breaks = { ["true"] = { mirrored = alike, scaled = alike } } },
  },
  equals = {
    { when = { half_resolution = false, directions = "one", cheap = false, nearest_depth = false }, pipeline = "ue4" },
  },
  build = function(p)
    local raster = scene.raster()
    local layer = flattened(p, raster)
    local has_two = p.directions() == "two"
    local around = tiles.dominant(p, layer, { second = has_two })
    local images = gathers.images(layer, around)
    local shortest = (p.cheap() or p.half_resolution()) and tile_min { velocity = layer.velocity }.shortest or nil
    if p.cheap() then
      images.slowest = neighbour_min { shortest = shortest, max_displacement = around.max_displacement }.slowest
    end
    local mask = p.half_resolution() and half_grid { shortest = shortest }.mask or nil
    local listed = mask and compact.pixels(mask, "half") or nil
    local color = blurred(images, "gather", listed)
    if has_two then
      images.dominant = around.second
      color = mean { mean_a = color, mean_b = blurred(images, "second_gather", listed) }.color
    end
    if mask then color = half_fill { blurred = color, mask = mask }.filled end
    return scene.outputs(raster, { color = color })
  end,
}
