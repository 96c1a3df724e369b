-- SPDX-License-Identifier: MIT
-- The motion blur of the Bevy engine (2024): blur of each pixel along its own displacement. The exposure may have any position
-- relative to the raster time (anchor).
local pass   = require "strobe.pass"
local blur   = require "passes.lib.blur"
local ports  = require "passes.lib.blur_ports"
local jitter = require "passes.lib.jitter"

return pass.compute {
  doc    = "Blur of each pixel along its own displacement. A tap on a surface behind the pixel's surface always " ..
           "counts. Any other tap counts only if the motion of its surface covers the distance from the tap to the " ..
           "pixel",
  fails  = "Surfaces do not blur beyond their silhouettes: a static pixel stays unchanged even if a surface passes " ..
           "over it. Inside a silhouette, the background is copied from outside. Taps on nearer surfaces count even " ..
           "if these surfaces move away from the pixel, because the sign of the motion is ignored.",
  size   = { of = "color" },
  reads  = ports.of { "color", "depth", "velocity" },
  writes = ports.picture,
  if_no = ports.no_motion,
  params = {
    samples      = blur.samples { doc = "number of taps along the pixel's own displacement" },
    limit        = blur.limit,
    copy_below   = pass.float { 1, min = 0, max = 16, unit = "px",
      doc = "smallest displacement over the exposure that is blurred. Whatever this value, a surface that stays within " ..
            "half a pixel of its raster position is not blurred" },
    jitter       = jitter.jitter,
    jitter_frame = jitter.jitter_frame,
  },
  counters = {
    clamped = {
      doc   = "pixels that move farther than the limit of displacements",
      limit = "each such displacement was shortened, so that the blur is too short; ground truth has no limit. " ..
              "Raise `limit`, or shorten the exposure",
    },
    copied = "pixels copied without blur, because they move less than `copy_below`",
  },
}
