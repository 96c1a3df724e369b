-- SPDX-License-Identifier: MIT
-- Joint upsampling of a revealed layer that has one ray per 2x2 pixels.
-- Source: Kopf, Cohen, Lischinski, Uyttendaele, "Joint Bilateral Upsampling", SIGGRAPH 2007; guided by ids and depths.
local pass   = require "strobe.pass"
local blur   = require "passes.lib.blur"
local stored = require "passes.lib.stored"

return pass.compute {
  name   = "reveal_upsample",
  shader = "scene/reveal_upsample",
  doc    = "A revealed layer of half resolution at full resolution",
  size   = { of = "hit" },
  scene  = true,
  reads  = {
    hit             = { uint = true, doc = "instance + 1 (0 = sky), geometry, primitive of the foreground" },
    mask            = { doc = "1 where something is to be revealed" },
    front_depth     = { doc = "linear view depth of the foreground, metres" },
    color           = { doc = "linear, half resolution" },
    depth           = { doc = "linear view depth, metres, sky = +inf, half resolution" },
    id              = { uint = true, doc = "instance + 1, geometry + 1, half resolution" },
    velocity        = { doc = "px over the exposure, half resolution" },
    valid           = { doc = "above 1/2 where something was revealed, half resolution" },
  },
  writes = {
    color    = { format = stored.color, doc = "linear radiance of what is revealed; 0 where nothing is" },
    depth    = { format = "r32f", doc = "its linear view depth, metres; sky = +inf, 0 where nothing is revealed" },
    id       = { format = "rg32ui", doc = "its instance + 1, geometry + 1; 0 for sky and where nothing is" },
    velocity = { format = stored.velocity, doc = "its displacement over the exposure, px" },
    valid    = { format = "r8_unorm", doc = "1 where something is revealed" },
  },
  without = { mask = { color = 0, depth = 0, id = 0, velocity = 0, valid = 0 } },
  fails  = "Detail of the revealed surface finer than 2 pixels is smoothed or missed, and silhouettes in it move " ..
           "by up to a pixel. Foregrounds narrower than 2 pixels may have no ray of their own.",
  params = {
    velocity_format = stored.velocity_format,
    color_format    = stored.color_format,
    depth_encoding  = stored.depth_encoding,
    depth_extent = blur.depth_extent { doc = "share of the depth over which two depths count as one surface" },
  },
  counters = {
    unmatched = "masked pixels near which no ray revealed what lies behind their own surface",
    velocity_clamped = stored.counters.velocity_clamped,
    color_clamped    = stored.counters.color_clamped,
    depth_lost       = stored.counters.depth_lost,
  },
}
