-- SPDX-License-Identifier: MIT
-- A ray at a time of its own for each pixel near motion. Cook, Porter and Carpenter 1984, "Distributed Ray Tracing".
local pass  = require "strobe.pass"
local blur  = require "passes.lib.blur"
local jitter = require "passes.lib.jitter"
local shade = require "passes.scene.shade"

local drawn = "the time of a pixel is drawn by its place"

return pass.trace {
  name   = "one_time",
  shader = "scene/one_time",
  doc    = "What each pixel sees at one random time of the exposure, where something moves around it",
  fails  = "As noise: one time stands for all. What moves where no tile around has a displacement, coming in from outside of "
    .. "the picture, is not looked for.",
  breaks = { mirrored = drawn, shifted = drawn, reversed = drawn, uniform = "a pixel sees one time, at random" },
  size   = { of = "color" },
  reads  = {
    color    = { doc = "linear, of what the capture sees" },
    velocity = { doc = "px over the exposure, of what the capture sees" },
    dominant = { doc = "px over the exposure, per tile, at most the limit" },
  },
  writes = {
    noisy = { format = "rgba32f", doc = "linear, alpha 1: what the pixel sees then, shaded as at the capture" },
    moved = { format = "rg32f", doc = "displacement over the exposure of what it sees then, px" },
  },
  without = { motion = { noisy = "color", moved = "velocity" } },
  params = { tile = blur.tile, jitter_frame = jitter.jitter_frame },
  counters = {
    rays       = "pixels that had a ray",
    not_finite = shade.counters.not_finite,
  },
}
