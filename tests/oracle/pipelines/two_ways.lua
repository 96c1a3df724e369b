-- SPDX-License-Identifier: MIT
-- Hits and displacements by rasterisation and by ray tracing.
local pipeline   = require "strobe.pipeline"
local gbuffer    = require "passes.gbuffer.gbuffer"
local visibility = require "passes.gbuffer.visibility"
local shade      = require "passes.gbuffer.shade"
local traced     = require "passes.gbuffer.visibility_traced"

return pipeline {
  doc = "Hits, displacements and colours by rasterisation and by ray tracing",
  build = function()
    local raster, rays = visibility {}.hit, traced {}.hit
    local seen, found = gbuffer { hit = raster }, gbuffer { hit = rays, as = "ray_gbuffer" }
    return {
      color = shade { hit = raster, shading = "frozen" }.color, hit = raster, velocity = seen.velocity, ray_hit = rays,
      ray_velocity = found.velocity, ray_color = shade { hit = rays, shading = "frozen", as = "ray_shade" }.color,
    }
  end,
}
