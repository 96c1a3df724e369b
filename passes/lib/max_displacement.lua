-- SPDX-License-Identifier: MIT
-- Input port of the passes that search around a pixel. If the parameter `limit` of a pass is auto, the value of the
-- port is the search radius.
return { optional = true, buffer = true,
  doc = "entry 0: length of the longest displacement of the image, px over the exposure, as the bits of a float. " ..
        "With limit = auto, this length is the search radius, px; if the port is absent, the search radius is twice " ..
        "the image's diagonal" }
