-- SPDX-License-Identifier: MIT
-- Input ports of the passes that compute the screen paths of a layer's surfaces over the exposure.
return {
  depth    = { doc = "linear view depth, metres; +inf for the sky, 0 where the layer has no surface" },
  id       = { uint = true, doc = "instance index + 1; 0 for the sky" },
  hit      = { optional = true, uint = true,
    doc = "surface, by indices: instance + 1 (0 for the sky), geometry, triangle; absent: joints and morph targets are " ..
          "ignored" },
}
