-- SPDX-License-Identifier: MIT
-- Read that gives a pass its search radius if `limit` is auto.
return { optional = true,
  doc = "longest displacement of the image, one texel, px over the exposure; absent: twice the diagonal of the image" }
