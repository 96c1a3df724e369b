-- SPDX-License-Identifier: MIT
-- Deferred shading of the visible surface of each pixel, with traced shadows.
local pass      = require "strobe.pass"
local quantised = require "passes.lib.quantised"

return pass.trace {
  doc    = "Colour of the visible surface of each pixel at the raster time, with traced shadows",
  size   = { of = "hit" },
  reads  = {
    hit              = { uint = true, doc = "visible surface, by indices: instance + 1 (0 for the sky), geometry, triangle" },
    light_visibility = { uint = true, optional = true, needs = "light_visibility",
      doc = "lights that are visible, or blocked, from a whole tile, as bits from `tile_light_visibility`; these lights " ..
            "need no shadow rays" },
  },
  writes = { color = { format = quantised.color, doc = "colour, linear radiance; alpha 1" } },
  counters = {
    not_finite = {
      doc   = "radiances that were not finite numbers",
      limit = "NaN became 0 and infinity 65504. Check the textures, lights and normals of the visible objects",
    },
    color_clamped = quantised.counters.color_clamped,
  },
  params = {
    color_format = quantised.color_format,
    shadow_tile = pass.int { 8, min = 1, max = 64, unit = "px", wired = true,
      doc = "side of a tile of pixels for the light visibility test: one test of a tile and a light may replace the " ..
            "shadow rays of all pixels of the tile" },
    shading = pass.choice { "frozen", "full", default = "frozen", role = "shading",
      doc = "time of the poses used for shading: the raster time, or the time of the sample",
      values = {
        frozen = "Shading as at the raster time for all samples, as in a filter that blurs one image. Fails where light, " ..
                 "shadows or highlights move within the exposure: they stay fixed.",
        full   = "Shading at the time of each sample. Never fails: light, shadows and highlights move within the exposure.",
      } },
  },
}
