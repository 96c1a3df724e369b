-- SPDX-License-Identifier: MIT
-- A mask that is the same everywhere.
local pass = require "strobe.pass"

return pass.compute {
  name   = "mask_constant",
  shader = "mask/constant",
  doc    = "Everywhere or nowhere",
  fails  = "Everywhere costs a ray for every pixel; nowhere leaves out what every silhouette uncovers.",
  writes = { mask = { format = "r8_unorm", doc = "1 where something is to be revealed" } },
  params = { everywhere = pass.bool { false, doc = "reveal behind every pixel" } },
}
