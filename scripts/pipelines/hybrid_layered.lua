-- SPDX-License-Identifier: MIT
-- Extension of the pipeline `hybrid`. Rays find the background that becomes visible because the foreground moves relative to
-- it. The raster layer and this revealed background are composited separately at each time sample.
local pass     = require "strobe.pass"
local pipeline = require "strobe.pipeline"
local layered  = require "passes.layered.layered_composite"
local reveal   = require "passes.hybrid.ray_reveal"
local layers   = require "scripts.pipelines.lib.layers"
local options  = require "scripts.pipelines.lib.options"
local paths    = require "scripts.pipelines.lib.paths"

return pipeline {
  doc = "Hybrid that traces rays where relative motion disoccludes a background, and composites two layers per time sample",
  params = {
    options.tiles(40),
    termination  = reveal.params.termination,
    tolerance    = reveal.params.tolerance,
    luminance_of = reveal.params.luminance_of,
    same_motion  = reveal.params.same_motion,
    advance      = reveal.params.advance,
    max_layers   = reveal.params.max_layers,
    on_cap       = reveal.params.on_cap,
    range        = paths.range,
    trajectory   = layered.params.trajectory,
  },
  compare_with = "mcguire2012",
  build = function(p)
    paths.require_curves(p, layered, "hybrid_layered")
    local both = layers.both(p)
    local images = layers.images(p, both.raster, both.revealed, layered)
    return layers.outputs(p, both, layered(pass.wired(layered, images, { as = "composite" })).blurred)
  end,
}
