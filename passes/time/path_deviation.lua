-- SPDX-License-Identifier: MIT
-- Path deviation over the exposure from a straight line.
local pass      = require "strobe.pass"
local followed  = require "passes.lib.followed"
local quantised = require "passes.lib.quantised"

local none = { path_deviation = 0, nonlinear = 0 }

return pass.compute {
  doc    = "Path deviation of a layer's surfaces from the straight line between their positions at shutter open and close",
  size   = { of = "velocity" },
  scene  = true,
  reads  = followed,
  writes = {
    path_deviation = { format = quantised.velocity, cleared = true,
      doc = "at mid-exposure, offset of the surface from the straight line between the ends of its path, px" },
    nonlinear = { format = "r8_unorm", cleared = true,
      doc = "1 where the path deviation exceeds `max_deviation`, or the stretch exceeds `max_stretch`" },
  },
  if_no = { motion = none, curves = none, moving_rect = none },
  params = {
    velocity_format = quantised.velocity_format,
    max_deviation = pass.float { 0.5, min = 0, max = 1000, unit = "px",
      doc = "largest path deviation, at mid-exposure, of a path that counts as straight" },
    max_stretch = pass.float { 1.5, min = 1, max = 1000, unit = "px",
      doc = "largest distance, within the exposure, of surface points that are one pixel apart at the raster time; at " ..
            "larger distances the taps of a filter leave holes" },
  },
  counters = { velocity_clamped = quantised.counters.velocity_clamped },
  fails  = "A path that crosses its straight line in the middle of the exposure, such as a fast oscillation, is treated as " ..
           "straight.",
}
