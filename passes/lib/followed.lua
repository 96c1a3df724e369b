-- SPDX-License-Identifier: MIT
-- What passes read of a layer whose surfaces they follow over the exposure.
return {
  depth    = { doc = "linear view depth, metres; sky = +inf, 0 where the layer has nothing" },
  id       = { uint = true, doc = "instance + 1 (0 = sky)" },
  velocity = { doc = "displacement over the exposure, px" },
  hit      = { optional = true, uint = true,
    doc = "instance + 1 (0 = sky), geometry, primitive; absent: joints and morph targets are not followed" },
  normal   = { optional = true, doc = "unit, world space; sky = 0; absent: growth is not looked at" },
}
