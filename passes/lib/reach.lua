-- SPDX-License-Identifier: MIT
-- The read by which passes that look around for what moves know how far to look, where the limit is auto.
return { optional = true, doc = "px over the exposure, longest of the picture, one texel; absent: as far as it is wide" }
