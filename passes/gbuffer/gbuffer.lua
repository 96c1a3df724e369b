-- SPDX-License-Identifier: MIT
-- G-buffer, derived from the visible triangle of each pixel. The same functions compute these values at the hits of
-- rays.
local pass      = require "strobe.pass"
local quantised = require "passes.lib.quantised"

return pass.compute {
  doc    = "Depth, normal, ids and displacement of the visible surface of each pixel",
  size   = { of = "hit" },
  scene  = true,
  reads  = { hit = { uint = true, doc = "visible surface, by indices: instance + 1 (0 for the sky), geometry, triangle" } },
  writes = {
    depth    = { format = "r32f", doc = "linear view depth, metres; +inf for the sky" },
    normal   = { format = "rgba32f", doc = "unit normal towards the camera, world space; 0 for the sky" },
    id       = { format = "rg32ui", doc = "instance index + 1, geometry index + 1; 0 for the sky" },
    velocity = { format = quantised.velocity,
      doc = "screen displacement of the surface, x right, y down, px over the exposure; not shortened to the displacement " ..
            "limit" },
  },
  params = {
    velocity_format = quantised.velocity_format,
    depth_encoding  = quantised.depth_encoding,
    displacement = pass.choice { "window", "extrapolated", default = "window",
      doc = "poses that the displacement over the exposure is computed from",
      values = {
        window = "True poses at shutter open and shutter close. Fails where the path within the exposure is not a straight " ..
                 "line at constant speed.",
        extrapolated = "Poses of this frame and the previous one; the path between them is multiplied by the exposure in " ..
                       "frames. A renderer that keeps one earlier frame has no other poses. Fails where the velocity " ..
                       "changes from frame to frame, and at the first frame of a clip. With trajectory = quadratic, two " ..
                       "earlier frames are used.",
      } },
  },
  counters = {
    near_plane = {
      doc   = "pixels whose surface is behind the near plane at some time of the exposure",
      limit = "each such displacement is the path up to the near plane, extrapolated to the whole exposure; no straight " ..
              "line describes the true path. Ground truth is not affected. Shorten the exposure, or move the near plane " ..
              "towards the camera",
    },
    not_finite = {
      doc   = "pixels whose displacement is not a finite number",
      limit = "each such displacement was replaced by 0, so that the pixel is not blurred. Check the transforms of the " ..
              "visible objects for lengths beyond single precision",
    },
    stretched = {
      doc   = "pixels whose displacement is the path of one frame, stretched over an exposure of more than one frame",
      limit = "motion outside this frame is assumed to be the same as within it. Use displacement = window, or an exposure " ..
              "of at most one frame",
    },
    velocity_clamped = quantised.counters.velocity_clamped,
    depth_lost       = quantised.counters.depth_lost,
  },
  fails  = "One displacement per pixel: a curved path within the exposure is treated as a straight line.",
}
