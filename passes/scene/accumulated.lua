-- SPDX-License-Identifier: MIT
-- One time sample of what moves, added to the mean of those before it. Haeberli and Akeley 1990, "The Accumulation Buffer";
-- that shading is kept from one time for others is an idea of Ragan-Kelley et al. 2011, "Decoupled Sampling".
local pass  = require "strobe.pass"
local captured_color = require "passes.lib.captured_color"
local shade = require "passes.scene.shade"

return pass.trace {
  name   = "accumulated",
  shader = "scene/accumulated",
  doc    = "Adds what is seen of what moves at one time, in the colour that it has at the capture",
  fails  = "Highlights and shadows that move within the exposure stand still on what they are seen on.",
  size   = { of = "hit" },
  reads  = {
    hit    = { uint = true, doc = "what is seen at that time of what moves: instance + 1 (0 = nothing), geometry, primitive" },
    color  = { doc = "linear, of what the capture sees" },
    depth  = { doc = "its linear view depth, metres; sky = +inf" },
    id     = { uint = true, doc = "its instance + 1, geometry + 1; sky = 0" },
    ground = { doc = "of what is at rest behind what moves, alpha: linear view depth, metres; 0: it is what the capture sees" },
  },
  updates = { moving = { format = "rgba32f", doc = "mean of what moves and is seen, linear; alpha: number of times" } },
  params = {
    reused        = pass.bool { true, doc = "what the capture shows has its colour; else all is shaded at each time" },
    shades_unlike = captured_color.shades_unlike,
    unlike        = captured_color.unlike,
    detail_below  = captured_color.detail_below,
    same_depth    = captured_color.same_depth,
    where_reached = pass.bool { true, role = "still_once",
      doc = "leave out what nothing in motion reaches: there is nothing to add" },
  },
  counters = {
    shaded     = "samples that the capture does not show, or not finely enough: they were shaded",
    not_finite = shade.counters.not_finite,
  },
}
