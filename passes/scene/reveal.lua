-- SPDX-License-Identifier: MIT
-- What lies behind: a ray through each masked pixel, advanced past the object in front until another one is hit.
-- Source: Tan, Cui, Bhojan, "Hybrid MBlur", SIGGRAPH '20 Posters, section "Ray Reveal".
local pass    = require "strobe.pass"
local gbuffer = require "passes.scene.gbuffer"

return pass.trace {
  name   = "reveal",
  shader = "scene/reveal",
  doc    = "Colour, depth, ids and displacement of the surface behind the masked foreground",
  size   = { of = "hit" },
  reads  = {
    hit  = { uint = true, doc = "instance + 1 (0 = sky), geometry, primitive of the foreground" },
    mask = { doc = "1 where a ray is wanted" },
  },
  writes = {
    color    = { format = "rgba32f", doc = "linear radiance of what is revealed; 0 where nothing is" },
    depth    = { format = "r32f", doc = "its linear view depth, metres; sky = +inf, 0 where nothing is revealed" },
    id       = { format = "rg32ui", doc = "its instance + 1, geometry + 1; 0 for sky and where nothing is" },
    velocity = { format = "rg32f", doc = "its displacement over the exposure, px" },
    valid    = { format = "r8_unorm", doc = "1 where something is revealed" },
  },
  params = {
    displacement = gbuffer.params.displacement,
    termination = pass.choice { "luminance", "geometry", "instance", "motion", default = "instance",
      doc = "what counts as another object: another luminance (as published), geometry or instance, or an instance " ..
            "that moves otherwise" },
    advance = pass.choice { "origin_kept", "restart", default = "origin_kept",
      doc = "luminance only: keep the ray and raise its lower bound, or start a new ray at the hit (as published)" },
    max_layers = pass.int { 8, min = 1, max = 31, doc = "luminance and motion: most hits behind the foreground tried" },
    on_cap = pass.choice { "fallback", "last_hit", default = "fallback",
      doc = "at the cap: reveal nothing and count it, or take the last hit" },
    same_motion = pass.float { 1, min = 0, max = 1000, unit = "px",
      doc = "motion only: a surface that goes no farther from where the foreground would carry it belongs to it" },
    tolerance = pass.float { 0.01, min = 0, max = 1, doc = "luminance only: relative difference that ends it" },
  },
  counters = {
    revealed = "pixels with a revealed surface or sky",
    capped   = "pixels that met the cap on layers",
  },
}
