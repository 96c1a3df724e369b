-- SPDX-License-Identifier: MIT
-- Deviation of the screen paths of surfaces from straight lines, in the middle of the exposure.
local pass      = require "strobe.pass"
local followed  = require "passes.lib.followed"
local quantised = require "passes.lib.quantised"

local none = { path_deviation = 0, nonlinear = 0 }

return pass.compute {
  doc    = "Path deviation: offset, at mid-exposure, of a layer's surfaces from the straight lines between their positions " ..
           "at shutter open and shutter close",
  size   = { of = "velocity" },
  scene  = true,
  reads  = followed,
  writes = {
    path_deviation = { format = quantised.velocity, cleared = true,
      doc = "offset of the surface, at mid-exposure, from the straight line between the ends of its screen path, px" },
    nonlinear = { format = "r8_unorm", cleared = true,
      doc = "1 where the path deviation exceeds `max_deviation` px, or where surface points one pixel apart at the raster " ..
            "time are more than `max_stretch` px apart at shutter open or close; otherwise 0" },
  },
  if_no = { motion = none, curves = none, moving_rect = none },
  params = {
    velocity_format = quantised.velocity_format,
    max_deviation = pass.float { 0.5, min = 0, max = 1000, unit = "px",
      doc = "largest path deviation, at mid-exposure, of a path that counts as straight; a path that deviates more is " ..
            "marked as nonlinear" },
    max_stretch = pass.float { 1.5, min = 1, max = 1000, unit = "px",
      doc = "largest distance, within the exposure, of surface points that are one pixel apart at the raster time; at " ..
            "larger distances the taps of a filter leave holes" },
  },
  counters = { velocity_clamped = quantised.counters.velocity_clamped },
  fails  = "A path that crosses its straight line in the middle of the exposure, such as a fast oscillation, is treated as " ..
           "straight.",
}
