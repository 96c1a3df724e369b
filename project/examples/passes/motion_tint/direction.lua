-- SPDX-License-Identifier: MIT
-- Tint of moving pixels by the direction of their motion: a choice of the parameter `tint` of pipelines/motion_tint.lua.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Tint of moving pixels by their direction: right red, down green, left cyan, up violet",
  fails  = "Slow and fast motion in one direction have the same tint.",
  size   = { of = "color" },
  reads  = {
    color    = { pointwise = true, doc = "colour, linear radiance" },
    velocity = { pointwise = true, doc = "displacement, px over the exposure" },
  },
  writes = { tinted = { format = "rgba32f", doc = "tinted colour, linear radiance; alpha 1" } },
  if_no  = { motion = { tinted = "color" }, moving_rect = { tinted = "color" } },
}
