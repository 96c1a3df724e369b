-- SPDX-License-Identifier: MIT
-- Piecewise linear motion of a layer in two segments, before and after the raster time.
local pass      = require "strobe.pass"
local quantised = require "passes.lib.quantised"

return pass.compute {
  doc    = "Displacements of a layer's surfaces before and after the raster time, from true poses: a model of motion as two " ..
           "straight segments",
  size   = { of = "velocity" },
  scene  = true,
  reads  = {
    depth    = { doc = "linear view depth, metres; +inf for the sky, 0 where the layer has no surface" },
    id       = { uint = true, doc = "instance index + 1; 0 for the sky" },
    velocity = { doc = "screen displacement of the surface, px over the exposure" },
  },
  writes = {
    velocity_pre = { format = quantised.velocity,
      doc = "displacement in the part of the exposure before the raster time, scaled to the length of the whole exposure, " ..
            "px; equal to `velocity` if the exposure starts or ends at the raster time, or if the instance deforms" },
    velocity_post = { format = quantised.velocity,
      doc = "displacement in the part of the exposure after the raster time, scaled to the length of the whole exposure, " ..
            "px; equal to `velocity` if the exposure starts or ends at the raster time, or if the instance deforms" },
  },
  params = { velocity_format = quantised.velocity_format },
  counters = { velocity_clamped = quantised.counters.velocity_clamped },
  fails  = "Each segment is a straight line at constant speed: changes of direction or speed at other times than the raster " ..
           "time are ignored.",
}
