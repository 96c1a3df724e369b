-- SPDX-License-Identifier: MIT
-- Lee, Kwon and Oh 2024, "Real-Time Motion Blur Using Multi-Layer Motion Vectors": a search through full layers.
local pass   = require "strobe.pass"
local blur   = require "passes.lib.blur"
local ports  = require "passes.lib.blur_ports"
local jitter = require "passes.lib.jitter"

local more = {
  id = { uint = true, doc = "instance + 1, geometry + 1; sky = 0" },
  dominant      = { optional = true, doc = "px over the exposure, per tile, of the first two layers; absent: own ones only" },
  deep_dominant = { optional = true, doc = "the same of the layers behind them" },
}
for number = 2, 4 do
  local layer = ("layer_%d_"):format(number)
  more[layer .. "color"]    = { optional = true, doc = "linear, of the next surface behind; absent: there is none" }
  more[layer .. "depth"]    = { optional = true, doc = "linear view depth, metres, sky = +inf" }
  more[layer .. "velocity"] = { optional = true, doc = "px over the exposure" }
end

return pass.compute {
  name   = "layers2024",
  shader = "filter/layers2024",
  doc    = "Per time sample, of all layers the nearest texel back along a displacement which agrees with that",
  fails  = "What is in no layer is not there: what enters or has left, what faces away, and surfaces behind more layers than "
    .. "there are; where it is the nearest that is missing, what lies behind shows through. Displacements are searched for "
    .. "that are the pixel's own or their tile's longest: others that come here are missed. Motion that varies over a surface "
    .. "by more than `agreement` is not found.",
  breaks = {
    mirrored = "of displacements equally long, and of surfaces equally deep, those first in raster order count",
  },
  size   = { of = "color" },
  reads  = ports.of({ "color", "depth", "velocity" }, more),
  writes = ports.picture,
  without = ports.still,
  params = {
    samples      = blur.samples { doc = "time samples" },
    tile         = blur.tile,
    limit        = blur.limit,
    agreement    = pass.float { 1, min = 0, max = 1000, unit = "px",
      doc = "largest difference of displacements between a texel that counts and the path that leads to the texel" },
    jitter       = jitter.jitter,
    jitter_frame = jitter.jitter_frame,
  },
  counters = {
    missed = "time samples at which no layer has anything; the others stand for them",
    varied = {
      doc   = "time samples at which what is seen at the pixel goes on where it leads, but moves otherwise there",
      limit = "what lies behind it was taken: it shows through. Raise `agreement`, or shorten the exposure",
    },
  },
}
