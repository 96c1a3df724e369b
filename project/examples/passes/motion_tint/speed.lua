-- SPDX-License-Identifier: MIT
-- Tint of moving pixels by their speed. The files of passes/motion_tint are a family: each is a choice of the parameter `tint`
-- of pipelines/motion_tint.lua, and a new file is a new choice. All members of the family read and write
-- the same images.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Tint of moving pixels in red, stronger for faster pixels",
  fails  = "Speeds above `limit` look alike.",
  size   = { of = "color" },
  reads  = {
    color    = { pointwise = true, doc = "colour, linear radiance" },
    velocity = { pointwise = true, doc = "displacement, px over the exposure" },
  },
  writes = { tinted = { format = "rgba32f", doc = "tinted colour, linear radiance; alpha 1" } },
  if_no  = { motion = { tinted = "color" }, moving_rect = { tinted = "color" } },
  params = { limit = pass.float { 20, min = 1, max = 1000, unit = "px", doc = "displacement that gives the full tint" } },
}
