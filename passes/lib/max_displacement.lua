-- SPDX-License-Identifier: MIT
-- Read that gives a pass its search radius if `limit` is auto.
return { optional = true, buffer = true,
  doc = "entry 0: length of the longest displacement of the image, px over the exposure, as the bits of a " ..
    "float; absent: twice the image's diagonal" }
