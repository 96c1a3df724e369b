-- SPDX-License-Identifier: MIT
-- The geometry buffer, derived from what each pixel sees by the functions that rays use too.
local pass   = require "strobe.pass"
local stored = require "passes.lib.stored"

return pass.compute {
  name   = "gbuffer",
  shader = "scene/gbuffer",
  doc    = "Depth, normal, ids and displacement of what each pixel sees",
  size   = { of = "hit" },
  scene  = true,
  reads  = { hit = { uint = true, doc = "instance + 1 (0 = sky), geometry, primitive" } },
  writes = {
    depth    = { format = "r32f", doc = "linear view depth, metres; sky = +inf" },
    normal   = { format = "rgba32f", doc = "unit, world space, towards the camera; sky = 0" },
    id       = { format = "rg32ui", doc = "instance + 1, geometry + 1; sky = 0" },
    velocity = { format = stored.velocity, doc = "displacement over the exposure, px, x right, y down; never clamped" },
  },
  params = {
    velocity_format = stored.velocity_format,
    depth_encoding  = stored.depth_encoding,
    displacement = pass.choice { "window", "extrapolated", default = "window",
      doc = "what the displacement over the exposure is taken from",
      values = {
        window = "The true poses at both ends of the exposure. Fails where the motion bends within it.",
        extrapolated = "The path since the frame before the capture, times the exposure in frames: all that a renderer " ..
                       "knows that keeps one frame. Fails where the velocity changes from frame to frame, and at the " ..
                       "first frame of a clip. With trajectory = quadratic two frames are kept.",
      } },
  },
  counters = {
    near_plane = {
      doc   = "pixels whose surface is behind the near plane at some time of the exposure",
      limit = "their displacement is the path up to that plane, extrapolated to its full length: no straight line tells " ..
              "where they go. Truth does not share this. Shorten the exposure, or bring the near plane nearer",
    },
    not_finite = {
      doc   = "pixels whose displacement is not a finite number",
      limit = "it was replaced by 0: they are not blurred. Look at the transforms of what they show: lengths beyond " ..
              "single precision",
    },
    stretched = {
      doc   = "pixels whose displacement is the path of one frame, stretched over an exposure of more than one",
      limit = "the motion is taken to have gone on as before the frame that is known. Take displacement = window, or an " ..
              "exposure of at most 1",
    },
    velocity_clamped = stored.counters.velocity_clamped,
    depth_lost       = stored.counters.depth_lost,
  },
  fails  = "One displacement per pixel: motion that bends within the exposure is taken for a straight line.",
}
