-- SPDX-License-Identifier: MIT
-- Deferred shading of what each pixel sees, with traced shadows.
local pass   = require "strobe.pass"
local stored = require "passes.lib.stored"

return pass.trace {
  name   = "shade",
  shader = "scene/shade",
  doc    = "Colour of what each pixel sees, posed at the capture; lights cast traced shadows",
  size   = { of = "hit" },
  reads  = {
    hit  = { uint = true, doc = "instance + 1 (0 = sky), geometry, primitive" },
    sure = { uint = true, optional = true, needs = "sure", doc = "of `shadow_shafts`: what is known of shadow rays untraced" },
  },
  writes = { color = { format = stored.color, doc = "linear radiance; alpha 1" } },
  counters = {
    not_finite = {
      doc   = "radiances that were not finite numbers",
      limit = "NaN became 0 and infinity 65504. Look at textures, lights and normals of what is there",
    },
    color_clamped = stored.counters.color_clamped,
  },
  params = {
    color_format = stored.color_format,
    shadow_tile = pass.int { 8, min = 1, max = 64, unit = "px", wired = true,
      doc = "side of a tile, whose shadow rays towards a light may be answered all at once" },
    shading = pass.choice { "frozen", "full", default = "frozen", role = "shading",
      doc = "pose at which points are shaded: the capture's, or the node's own time",
      values = {
        frozen = "As at the capture, whenever the point is seen: what filters of one picture can know. Fails where " ..
                 "light, shadows or highlights move within the exposure: they stand still.",
        full   = "As at the time at which the point is seen. Nothing to fail: light, shadows and highlights move too.",
      } },
  },
}
