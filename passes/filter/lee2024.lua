-- SPDX-License-Identifier: MIT
-- Lee, Kwon and Oh 2024, "Real-Time Motion Blur Using Multi-Layer Motion Vectors": a search through full raster layers.
local pass   = require "strobe.pass"
local blur   = require "passes.lib.blur"
local ports  = require "passes.lib.blur_ports"
local jitter = require "passes.lib.jitter"

local more = {
  id = { uint = true, doc = "instance index + 1, geometry index + 1; 0 for the sky" },
  dominant      = { optional = true,
    doc = "longest displacement in the first two layers that can bring a surface to each tile, px over the exposure; " ..
          "absent: only the pixel's own displacements are tried" },
  deep_dominant = { optional = true,
    doc = "longest displacement in the third and fourth layer that can bring a surface to each tile, px over the exposure; " ..
          "absent: these displacements are not tried" },
}
for number = 2, 4 do
  local layer = ("layer_%d_"):format(number)
  more[layer .. "color"]    = { absent = 0, doc = "colour of a layer behind the first one, linear radiance" }
  more[layer .. "depth"]    = { absent = 0,
    doc = "linear view depth of a layer behind the first one, metres; +inf for the sky. A layer without this image " ..
          "is not searched" }
  more[layer .. "velocity"] = { absent = 0, doc = "screen displacement of a layer behind the first one, px over the " ..
                                                  "exposure" }
end

return pass.compute {
  doc    = "Search in up to four depth layers: at each time sample, the colour of the nearest texel that a " ..
           "displacement of the pixel or of its tile brings to the pixel at that time. The picture is the mean over " ..
           "the samples",
  fails  = "Surfaces in no layer are missing: surfaces that enter or have left the image, that face away from the camera, " ..
           "or that lie behind the last layer. The background shows through where a missing surface is the nearest. Only " ..
           "the pixel's own displacements and the longest displacements of its tile are tried: surfaces with other " ..
           "displacements are missed. Surfaces whose displacement varies by more than `agreement` are missed too.",
  breaks = {
    mirrored = "of equally long displacements, and of equally deep surfaces, the first one in raster order is used; " ..
      "in a mirrored scene this is another one",
  },
  size   = { of = "color" },
  reads  = ports.of({ "color", "depth", "velocity" }, more),
  writes = ports.picture,
  if_no = ports.no_motion,
  params = {
    samples      = blur.samples { doc = "number of time samples" },
    tile         = blur.tile,
    limit        = blur.limit,
    agreement    = pass.float { 1, min = 0, max = 1000, unit = "px",
      doc = "largest difference between the displacement of a texel and the tried displacement that leads to the texel; " ..
            "texels with a larger difference do not count" },
    jitter       = jitter.jitter,
    jitter_frame = jitter.jitter_frame,
  },
  counters = {
    missed = "time samples without a surface at the pixel in any layer; the mean omits them",
    varied = {
      doc   = "time samples that skip the visible surface because its displacement varies from texel to texel",
      limit = "a surface behind the visible one was used instead: it shows through. Raise `agreement`, or shorten the exposure",
    },
  },
}
