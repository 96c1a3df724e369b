-- SPDX-License-Identifier: MIT
-- Where each method stops being trustworthy: error against truth along axes that each grow to an extreme.
--   strobe bench --extremes --out docs/extremes --markdown docs/extremes.md
local extremes = require "strobe.extremes"

local function samples_of(value) return { samples = value } end

return extremes {
  title = "Where each method stops being trustworthy",
  note = "Every method against ground truth of the same anchor and the same pixel centres, while one thing grows to an " ..
         "extreme and all else stays. 16 samples per pixel for every method unless the axis says otherwise; one sample " ..
         "per pixel.",
  size = { 320, 180 },
  size_params = { "width", "height" },
  factor = 2,
  truth = { label = "ground truth", pipeline = "ground_truth", set = { samples = 256, times = "stratified" } },
  floor = { label = "floor", pipeline = "ground_truth", set = { samples = 16, times = "midpoint" } },
  methods = {
    { label = "no blur", pipeline = "none", lacks = { "samples", "velocity_format", "color_format", "depth_encoding" } },
    { label = "McGuire 2012", pipeline = "mcguire2012" },
    { label = "UE4-style", pipeline = "ue4" },
    { label = "Guertin 2014", pipeline = "guertin2014" },
    { label = "Jimenez 2014", pipeline = "jimenez2014" },
    { label = "hybrid (as published)", pipeline = "hybrid", set = { preset = "seed" } },
    { label = "hybrid (best)", pipeline = "hybrid", set = { preset = "best" } },
  },
  axes = {
    {
      name = "speed", title = "Speed", unit = "px over the exposure", scale = "log", benign = 12.8, region = "whole",
      values = { 0.01, 0.03, 0.1, 0.3, 0.6, 1, 2, 4, 8, 12.8, 15.5, 20, 31, 40, 64, 128, 320, 1280 },
      scene = "stability/passage",
      fixed = "A panel of 96 x 72 px moves to the right before a wall at 1.5 times its depth.",
      reading = "Up to half a pixel every method copies what the capture saw: hybrid (best) errs by {hybrid " ..
                "(best) @ 0.3} of the contrast at 0.3 px, no blur by {no blur @ 0.3}, the floor is {floor @ " ..
                "0.3}. The capture has one sample per pixel, so no filter knows where in its pixel an edge lies. " ..
                "About 1 px edges move in steps of a whole pixel: {hybrid (best) @ 1}. From 8 px to the limit " ..
                "hybrid (best) is as good as its samples allow ({hybrid (best) @ 12.8} at 12.8 px, floor {floor " ..
                "@ 12.8}). The others err by {Jimenez 2014 @ 12.8} to {McGuire 2012 @ 12.8} there, nearly all of " ..
                "it inside the leading edge: Jimenez 2014 and UE4-style show what is mirrored from beside it, " ..
                "McGuire 2012, Guertin 2014 and hybrid (as published) leave the panel nearly opaque there. " ..
                "Beyond the limit (10 % of the width, 32 px; 16 px for UE4-style) displacements are shortened " ..
                "and every method says so in its record: at 40 px hybrid (best) errs by {hybrid (best) @ 40}, at " ..
                "128 px by {hybrid (best) @ 128}, where no blur errs by {no blur @ 128}.",
      at = function(value) return { scene = { speed = value } } end,
    },
    {
      name = "samples", title = "Samples", unit = "per pixel", scale = "log", benign = 16, region = "inner",
      values = { 1, 2, 4, 6, 8, 12, 16, 24, 32, 64, 128, 256 },
      scene = "stability/passage",
      fixed = "The panel moves by 12.8 px. Truth at a method's own samples has as many as the method.",
      reading = "hybrid (best) follows the floor up to 16 samples ({hybrid (best) @ 16}, floor {floor @ 16}) and " ..
                "gains little beyond 32: at 256 it errs by {hybrid (best) @ 256} where the floor is {floor @ " ..
                "256} and truth's own error {truth @ 256}. What is left are stairs: a tap is the nearest pixel, " ..
                "so what it shows is up to half a pixel off. The others do not get better with samples, since " ..
                "their error is what they show and not how often they look: Jimenez 2014 has {Jimenez 2014 @ 16} " ..
                "with 16 and {Jimenez 2014 @ 256} with 256.",
      at = function(value) return { set = samples_of(value), floor = samples_of(value), truth = { samples = 1024 } } end,
    },
    {
      name = "scale", title = "Scale of the scene", unit = "times all lengths", scale = "log", benign = 1,
      region = "inner", same_picture = true, values = { 1e-6, 1e-4, 0.01, 1, 100, 1e4, 1e6 }, scene = "stability/passage",
      fixed = "The panel moves by 12.8 px. At 1 it is 10 m away.",
      reading = "No method changes from 1e-6 to 1e6: hybrid (best) errs by {hybrid (best) @ 1e-06}, {hybrid " ..
                "(best) @ 1} and {hybrid (best) @ 1000000}. Depths are compared as shares of each other and " ..
                "transforms are relative to the camera, so no constant of a method is a length. What little " ..
                "changes in truth are single samples at silhouettes that rounding turns over.",
      at = function(value) return { scene = { scale = value } } end,
    },
    {
      name = "offset", title = "Distance from the origin", unit = "m along each axis", scale = "log", benign = 0,
      region = "inner", same_picture = true,
      values = { 0, 1, 100, 1e4, 1e6, 1e7 }, scene = "stability/passage",
      fixed = "Camera and scene are moved together. The panel moves by 12.8 px.",
      reading = "No method changes up to 10 000 km from the origin: hybrid (best) errs by {hybrid (best) @ 0} " ..
                "there and {hybrid (best) @ 10000000} here. Transforms are made in double precision and " ..
                "relative to the camera before they become single. This is about where things are placed, not " ..
                "about vertices that are themselves written far from their node: these are rounded in the file.",
      at = function(value) return { scene = { offset = value } } end,
    },
    {
      name = "gap", title = "Depth of the background", unit = "share of the front's depth, beyond it", scale = "log",
      benign = 0.5, region = "inner", same_picture = true,
      values = { 1e-6, 1e-4, 1e-3, 3e-3, 0.01, 0.03, 0.1, 0.5, 10, 100, 9999 },
      scene = "stability/passage",
      fixed = "The panel moves by 12.8 px, 10 m away. The wall grows with its depth, so that it looks the same.",
      reading = "hybrid (best) asks depths only which of two surfaces is nearer, and instances for the rest: {hybrid (best) " ..
                "@ 1e-06} at a millionth, {hybrid (best) @ 9999} at ten thousand times. " ..
                "Jimenez 2014 and UE4-style mirror the " ..
                "background only from what is clearly behind: below a hundredth of the depth (depth_extent) they " ..
                "no longer do, and err by {Jimenez 2014 @ 0.0001} instead of {Jimenez 2014 @ 0.5}. hybrid (as " ..
                "published) wants an edge of a twentieth of the depth before it reveals anything; below it " ..
                "reveals nothing and is McGuire 2012 bit for bit ({hybrid (as published) @ 0.03}, {McGuire 2012 " ..
                "@ 0.03}).",
      at = function(value) return { scene = { gap = value } } end,
    },
    {
      name = "angle", title = "Direction of motion", unit = "degrees from the horizontal", scale = "linear", benign = 0,
      region = "inner", values = { 0, 15, 30, 45, 60, 75, 90 },
      scene = "stability/passage", fixed = "The panel moves by 12.8 px.",
      reading = "No direction is worse than another by much: hybrid (best) errs by {hybrid (best) @ 0} along the " ..
                "rows, {hybrid (best) @ 45} along the diagonal and {hybrid (best) @ 90} along the columns, with " ..
                "floors of {floor @ 0}, {floor @ 45} and {floor @ 90}. What changes is which cells of wall and " ..
                "panel are hidden and shown.",
      at = function(value) return { scene = { angle = value } } end,
    },
    {
      name = "grazing", title = "Grazing angle of the moving surface", unit = "degrees between its normal and the view",
      scale = "even", benign = 0, region = "inner", same_picture = true,
      values = { 0, 30, 60, 75, 85, 88, 89.5, 89.9 },
      scene = "stability/grazing",
      fixed = "A panel of 96 x 72 px turns about the eye by 8 px.",
      reading = "A panel that is seen nearly edge on, whose depth changes by up to a tenth of itself from pixel to " ..
                "pixel, is blurred as well as one that faces the camera: hybrid (best) errs by {hybrid (best) @ 0} facing " ..
                "and by {hybrid (best) @ 89.9} at 89.9 degrees, McGuire 2012 by {McGuire 2012 @ 0} and " ..
                "{McGuire 2012 @ 89.9}.",
      at = function(value) return { scene = { tilt = value, speed = 8 } } end,
    },
  },
  cases = {
    { label = "12.8 px", scene = "stability/passage" },
    { label = "1 px", scene = "stability/passage", set = { speed = 1 } },
    { label = "31 px", scene = "stability/passage", set = { speed = 31 } },
    { label = "background 1e-6 beyond", scene = "stability/passage", set = { gap = 1e-6 } },
    { label = "background 9999 beyond", scene = "stability/passage", set = { gap = 9999 } },
    { label = "tilted by 89.9 degrees", scene = "stability/grazing", set = { tilt = 89.9, speed = 8 } },
  },
  variants = {
    { name = "velocity_format", title = "Displacements", reference = "fp32", values = { "fp32", "fp16" },
      reading = "Half floats save 0.2 to 0.4 MiB of 5 to 8 and change no error by as much as its third digit, but for " ..
                "hybrid (best) at 1 px, where edges move by whole pixels: there pixels change by up to " ..
                "{change hybrid (best), fp16 @ 1 px}, and its error grows from {hybrid (best), fp32 @ 1 px} to " ..
                "{hybrid (best), fp16 @ 1 px}. No time is saved beyond the noise. The default is fp32." },
    { name = "color_format", title = "Colours", reference = "fp32", values = { "fp32", "fp16" },
      reading = "Half floats save 0.4 to 1.3 MiB and change pixels by at most 0.00044, a 2000th of white, and no error in " ..
                "its third digit. The default is fp32, since pictures are measured here; where memory counts, this is the " ..
                "first to give up." },
    { name = "depth_encoding", title = "Depths", reference = "linear",
      values = { "linear", "reversed", "inverse", "unorm24" },
      reading = "All four are 4 bytes per pixel and err alike; what differs is in the sixth digit, at surfaces a millionth " ..
                "of the depth apart or seen edge on. The default is linear, which rounds nothing." },
  },
}
