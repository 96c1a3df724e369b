-- SPDX-License-Identifier: MIT
-- Hits and displacements of what raster sees and of what rays see.
local pipeline   = require "strobe.pipeline"
local gbuffer    = require "passes.gbuffer.gbuffer"
local visibility = require "passes.gbuffer.visibility"
local shade      = require "passes.gbuffer.shade"
local traced     = require "passes.gbuffer.visibility_traced"

return pipeline {
  doc = "What raster sees, and what rays see",
  build = function()
    local raster, rays = visibility {}.hit, traced {}.hit
    local seen, found = gbuffer { hit = raster }, gbuffer { hit = rays, as = "ray_gbuffer" }
    return {
      color = shade { hit = raster, shading = "frozen" }.color, hit = raster, velocity = seen.velocity, ray_hit = rays,
      ray_velocity = found.velocity, ray_color = shade { hit = rays, shading = "frozen", as = "ray_shade" }.color,
    }
  end,
}
