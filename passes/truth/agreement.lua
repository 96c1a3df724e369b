-- SPDX-License-Identifier: MIT
-- What the first samples of truth agree about, so that the others need no rays for it.
local pass = require "strobe.pass"

return pass.compute {
  name   = "truth_agreement",
  shader = "truth/agreement",
  doc    = "Triangles at rest that all first samples of a pixel and its neighbours see, and colours that all have",
  fails  = "What is smaller than a pixel and falls between all of these samples is not known to be there.",
  size   = { of = "ground" },
  reads  = {
    ground = { uint = true, doc = "what samples have seen at rest: 0 nothing, 1 sky, 2 + instance; geometry, triangle" },
    still  = { doc = "rgb: mean colour of what is at rest" },
    unlike = { doc = "the farthest of its colours from the mean before it, in parts of that" },
    shadows = { uint = true, doc = "lights by bits: free from what is at rest at all samples, blocked" },
  },
  writes = {
    known_hit = { format = "rgba32ui", doc = "the triangle that all see, as `ground`; 0 where there is none" },
    known_shadows = { format = "rg32ui", doc = "lights by bits: free at all of these samples, blocked" },
    even_color = { format = "rgba32f", doc = "rgb: colour of what is at rest; a = 1 where that is one colour, else 0" },
  },
  params = {
    even_within = pass.float { 0.02, min = 0, max = 1,
      doc = "how far colours may be from their mean, in parts of it, to be one" },
  },
}
