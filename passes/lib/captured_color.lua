-- SPDX-License-Identifier: MIT
-- What passes share that give the capture's colour to what they see at other times (shaders/mixin/captured_color.glsl).
local param = require "strobe.param"

return {
  shades_unlike = param.bool { false, doc = "shade what lies between texels that differ, instead of taking their colour" },
  unlike        = param.float { 0.02, min = 0, max = 1, doc = "share of their colour by which these may differ" },
  detail_below  = param.float { 0.75, min = 0, max = 1e6, unit = "px",
    doc = "and only of what moves by no more than this from sample to sample" },
  same_depth    = param.float { 0.01, min = 0, max = 1, doc = "share of the depth over which two depths count as one" },
}
