-- SPDX-License-Identifier: MIT
-- What the first samples of truth agree about, so that the others need no rays for it.
local pass = require "strobe.pass"

return pass.compute {
  name   = "truth_agreement",
  shader = "truth/agreement",
  doc    = "What all first samples of a pixel and its neighbours see, its shadows, and colours that all have",
  fails  = "What is smaller than a pixel and falls between all of these samples is not known to be there.",
  size   = { of = "ground" },
  reads  = {
    ground = { uint = true, doc = "what samples have seen at rest, or where that is nothing in motion: 0 nothing, 1 sky, " ..
      "2 + instance; geometry, triangle" },
    still  = { doc = "rgb: mean colour of what is at rest" },
    unlike = { doc = "the farthest of its colours from the mean before it, in parts of that" },
    shadows = { uint = true, doc = "of two instances: whose, lights by bits (free at all that asked; " ..
      "from bit 16 on blocked; both: none did)" },
  },
  writes = {
    known_hit = { format = "rgba32ui",
      doc = "the surface that all see, as `ground`; its triangle is 2^32 - 1 where they see several; 0 where there is none" },
    known_shadows = { format = "rgba32ui", doc = "the same as all of these samples have it" },
    even_color = { format = "rgba32f", doc = "rgb: colour of what is at rest; a = 1 where that is one colour, else 0" },
    more = { format = "r8_unorm", doc = "0 where these samples are enough, else 1" },
  },
  params = {
    even_within = pass.float { 0.02, min = 0, max = 1,
      doc = "how far colours may be from their mean, in parts of it, to be one" },
    one_shading = pass.bool { true, wired = true, doc = "samples are shaded as at the capture: one colour may be enough" },
    audit = pass.float { 0, min = 0, max = 1, wired = true, doc = "share of the pixels that take all samples, to check them" },
  },
}
