-- SPDX-License-Identifier: MIT
-- Measures where each method is reliable. One quantity at a time (speed, number of samples, scale and others) varies to an
-- extreme, and the error against ground truth is measured.
--   strobe sweep experiments/extremes/extremes.lua -o out/extremes
local experiment = require "strobe.experiment"

local best = "adaptive"
local formats = { "velocity_format", "color_format", "depth_encoding" }
local cases = { "12.8 px", "1 px", "31 px", "background 1e-6 beyond", "background 9999 beyond",
                "tilted by 89.9 degrees" }
local list, each = experiment.list, experiment.each

local arms = { "no blur", "McGuire 2012", "UE4-style", "Guertin 2014", "Jimenez 2014", "hybrid (text)", best }
local scales = { 1e-6, 1e-4, 0.01, 1, 100, 1e4, 1e6 }
local offsets = { 0, 1, 100, 1e4, 1e6, 1e7 }

-- Returns the error of an arm at a value of an axis (a varied quantity).
local function error_at(r, axis, value, arm, region) return r.at { [axis] = value, arm = arm, region = region }.rmse end

local tolerance = "displacements that differ by at most 0.35 px count as equal, and at speeds up to 8 px the error " ..
                  "tolerance of the default quality keeps adaptive from a smaller error"

-- Returns an expectation. `of(r)` returns a deviation divided by the allowed deviation; the expectation holds if this is at
-- most 1. `known`: reason why the expectation fails; nil: it holds.
local function expectation(axis, text, of, known)
  return { text, axis = axis, known = known, function(r)
    local most = of(r)
    return most <= 1, ("%.3f of the allowed deviation"):format(most)
  end }
end

-- Returns the largest relative difference between the errors of `arm` at `values` of an axis and its error at the harmless
-- value `benign`, divided by the allowed difference `allowed`.
local function drift(r, axis, values, benign, arm, region, allowed)
  local base, most = error_at(r, axis, benign, arm, region), 0
  for _, value in ipairs(values) do
    most = math.max(most, math.abs(error_at(r, axis, value, arm, region) / base - 1))
  end
  return most / allowed
end

local function all_drift(axis, values, benign, allowed)
  return function(r)
    local most = 0
    for _, arm in ipairs(arms) do most = math.max(most, drift(r, axis, values, benign, arm, "inner", allowed)) end
    return most
  end
end

-- Returns a function of `r`. It returns the largest relative difference between the error with one of the formats
-- `values` and the error with the format `benign`, divided by the allowed difference `allowed`. The maximum is over all
-- cases and all arms that blur; a pair of these is left out if `except(arm, case)` is true.
local function format_drift(axis, values, benign, allowed, except)
  return function(r)
    local most = 0
    for _, case in ipairs(cases) do
      for i = 2, #arms do
        local base = r.at { [axis] = benign, arm = arms[i], shot = case }.rmse
        for _, value in ipairs(except(arms[i], case) and {} or values) do
          local own = r.at { [axis] = value, arm = arms[i], shot = case }.rmse
          most = math.max(most, math.abs(own / base - 1) / allowed)
        end
      end
    end
    return most
  end
end

local function nothing() return false end
local function tilted_best(arm, case) return arm == best and case == "tilted by 89.9 degrees" end

local speeds = { 0.01, 0.03, 0.1, 0.3, 0.6, 1, 2, 4, 8, 12.8, 15.5, 20, 31, 40, 64, 128, 320, 1280 }
local samples = { 1, 2, 4, 6, 8, 12, 16, 24, 32, 64, 128, 256 }

local expected = {
  expectation("speed", "up to 0.3 px every method has the error of no blur, to a thousandth", function(r)
    local most = 0
    for _, speed in ipairs { 0.03, 0.1, 0.3 } do
      local base = error_at(r, "speed", speed, "no blur", "whole")
      for i = 1, #arms do
        most = math.max(most, math.abs(error_at(r, "speed", speed, arms[i], "whole") / base - 1) / 1e-3)
      end
    end
    return most
  end),
  expectation("speed", "at every speed the error of adaptive is at most 1.3 times the error of truth with as many " ..
    "samples", function(r)
    local most = 0
    for _, speed in ipairs(speeds) do
      local floor = error_at(r, "speed", speed, "floor", "whole")
      if floor > 0 then most = math.max(most, error_at(r, "speed", speed, best, "whole") / (1.3 * floor)) end
    end
    return most
  end, tolerance),
  expectation("speed", "at 12.8 px every other method has at least five times the error of adaptive", function(r)
    local most, own = 0, error_at(r, "speed", 12.8, best, "whole")
    for i = 1, #arms - 1 do most = math.max(most, 5 * own / error_at(r, "speed", 12.8, arms[i], "whole")) end
    return most
  end),
  expectation("samples", "up to 64 samples the error of adaptive is at most 1.3 times the error of truth with as many " ..
    "samples", function(r)
    local most = 0
    for _, count in ipairs(samples) do
      local floor = error_at(r, "samples", count, "floor", "inner")
      if count <= 64 then most = math.max(most, error_at(r, "samples", count, best, "inner") / (1.3 * floor)) end
    end
    return most
  end),
  expectation("samples", "beyond 64 samples the error of adaptive falls by less than a hundredth", function(r)
    return 0.99 * error_at(r, "samples", 64, best, "inner") / error_at(r, "samples", 256, best, "inner")
  end),
  expectation("samples", "from 16 to 256 samples the errors of the other methods fall by less than a hundredth", function(r)
    local most = 0
    for i = 1, #arms - 1 do
      local few, many = error_at(r, "samples", 16, arms[i], "inner"), error_at(r, "samples", 256, arms[i], "inner")
      most = math.max(most, 0.99 * few / many)
    end
    return most
  end),
  expectation("scale", "no scale of the scene changes the error of a method by more than a thousandth",
     all_drift("scale", scales, 1, 1e-3)),
  expectation("offset", "no distance from the origin changes the error of a method by more than a thousandth",
     all_drift("offset", offsets, 0, 1e-3)),
  expectation("gap", "if the background is farther than the front by 1e-6 to 9999 times the front's depth, the " ..
    "error of adaptive changes by at most a thousandth", function(r)
    return drift(r, "gap", { 1e-6, 1e-4, 0.01, 10, 9999 }, 0.5, best, "inner", 1e-3)
  end),
  expectation("gap", "if the background is farther than the front by less than a thirtieth of the front's depth, " ..
    "hybrid (text) has the error of McGuire 2012", function(r)
    local most = 0
    for _, gap in ipairs { 1e-6, 1e-4, 1e-3, 3e-3, 0.01, 0.03 } do
      local base = error_at(r, "gap", gap, "McGuire 2012", "inner")
      most = math.max(most, math.abs(error_at(r, "gap", gap, "hybrid (text)", "inner") / base - 1) / 1e-6)
    end
    return most
  end),
  expectation("gap", "if the background is farther than the front by a ten-thousandth of the front's depth, the " ..
    "errors of Jimenez 2014 and UE4-style are at least a tenth larger than if it is farther by half of that " ..
    "depth", function(r)
    local most = 0
    for _, arm in ipairs { "Jimenez 2014", "UE4-style" } do
      most = math.max(most, 1.1 * error_at(r, "gap", 0.5, arm, "inner") / error_at(r, "gap", 1e-4, arm, "inner"))
    end
    return most
  end),
  expectation("angle", "no direction of motion changes the error of adaptive by more than a third", function(r)
    return drift(r, "angle", { 15, 30, 45, 60, 75, 90 }, 0, best, "inner", 1 / 3)
  end),
  expectation("grazing", "up to an angle of 89.9 degrees the error of adaptive grows by at most a thousandth", function(r)
    local most, facing = 0, error_at(r, "grazing", 0, best, "inner")
    for _, angle in ipairs { 30, 60, 75, 85, 88, 89.5, 89.9 } do
      most = math.max(most, (error_at(r, "grazing", angle, best, "inner") / facing - 1) / 1e-3)
    end
    return most
  end),
  expectation("velocity_format", "half floats for displacements change no error by more than a thousandth",
    format_drift("velocity_format", { "fp16" }, "fp32", 1e-3, nothing)),
  expectation("color_format", "half floats for colours change no error by more than a five-hundredth, except the error of " ..
    "adaptive for the tilted panel",
    format_drift("color_format", { "fp16" }, "fp32", 2e-3, tilted_best)),
  expectation("depth_encoding", "no depth encoding changes an error by more than a ten-thousandth",
    format_drift("depth_encoding", { "reversed", "inverse", "unorm24" }, "linear", 1e-4, nothing)),
}

return experiment {
  title = "Reliable range of each method",
  note = "Every method is compared with ground truth with the same anchor. One quantity varies to an extreme, and all " ..
         "others are constant. Every method has 16 time samples, except along the axis of samples. All methods sample the " ..
         "centres of pixels.",
  size = { 320, 180 },
  size_params = { "width", "height" },
  measures = { "rmse" },
  rounds = 9,
  truth = { pipeline = "ground_truth", set = { samples = 256, times = "stratified" } },
  arms = {
    { name = "no blur", pipeline = "none", lacks = { "samples" } },
    { name = "McGuire 2012", pipeline = "mcguire2012" },
    { name = "UE4-style", pipeline = "ue4" },
    { name = "Guertin 2014", pipeline = "guertin2014" },
    { name = "Jimenez 2014", pipeline = "jimenez2014" },
    { name = "hybrid (text)", pipeline = "hybrid", set = { preset = "text" } },
    { name = "adaptive", pipeline = "adaptive" },
    { name = "floor", pipeline = "ground_truth", role = "floor", set = { samples = 16, times = "midpoint" } },
  },
  shots = {
    { name = "passage", scene = "stability/passage" },
    { name = "grazing", scene = "stability/grazing", ["scene.speed"] = 8 },
    { name = "12.8 px", scene = "stability/passage" },
    { name = "1 px", scene = "stability/passage", ["scene.speed"] = 1 },
    { name = "31 px", scene = "stability/passage", ["scene.speed"] = 31 },
    { name = "background 1e-6 beyond", scene = "stability/passage", ["scene.gap"] = 1e-6 },
    { name = "background 9999 beyond", scene = "stability/passage", ["scene.gap"] = 9999 },
    { name = "tilted by 89.9 degrees", scene = "stability/grazing", ["scene.speed"] = 8, ["scene.tilt"] = 89.9 },
  },
  vary = { each {
    list {
      name = "speed", title = "Speed", unit = "px over the exposure", scale = "log", benign = 12.8, region = "whole",
      values = speeds,
      shots = { "passage" },
      fixed = "A panel of 96 x 72 px moves to the right in front of a wall at 1.5 times the panel's depth.",
      reading = "Up to half a pixel, filters copy the rasterised image: at 0.3 px the error of UE4-style is " ..
                "{UE4-style @ 0.3} of the contrast, the same as without blur. Adaptive copies the rasterised image " ..
                "if displacements differ by at most 0.35 px: at 0.3 px its error is {adaptive @ 0.3}. The error of " ..
                "truth with 16 samples is {floor @ 0.3}. At 1 px the error of UE4-style is {UE4-style @ 1}. The " ..
                "rasterised image has one sample per pixel, so a filter cannot locate an edge within its pixel, and " ..
                "edges move in steps of a whole pixel. The rays of adaptive locate the edge: the error of adaptive " ..
                "is {adaptive @ 1}, and the error of truth with 16 samples {floor @ 1}. At 12.8 px the error of " ..
                "adaptive is {adaptive @ 12.8}, and the error of truth with 16 samples {floor @ 12.8}. The errors of " ..
                "the other methods are {Jimenez 2014 @ 12.8} to {McGuire 2012 @ 12.8}, nearly all of them inside the " ..
                "leading edge. Inside this edge, Jimenez 2014 and UE4-style mirror colours from outside, and McGuire " ..
                "2012, Guertin 2014 and hybrid (text) leave the panel nearly opaque. At 40 px and more, " ..
                "displacements are not shortened: the error of adaptive is {adaptive @ 40} at 40 px and " ..
                "{adaptive @ 128} at 128 px, where the error of no blur is {no blur @ 128}.",
      at = function(value) return { ["scene.speed"] = value } end,
    },
    list {
      name = "samples", title = "Samples", unit = "per pixel", scale = "log", benign = 16, region = "inner",
      values = samples,
      shots = { "passage" },
      fixed = "The panel moves by 12.8 px. The floor has as many samples as the methods.",
      reading = "The error of adaptive is below the floor up to 64 samples. With 64 samples the error of adaptive " ..
                "is {adaptive @ 64}, and the floor {floor @ 64}. More samples hardly reduce the error of adaptive, " ..
                "because it depends on the error tolerance of the quality: with 256 samples it is {adaptive @ 256}, " ..
                "the floor {floor @ 256}, and truth's own error {truth @ 256}. The errors of the other methods do " ..
                "not fall with more samples, because they come from a wrong background and not from noise: Jimenez " ..
                "2014 has {Jimenez 2014 @ 16} with 16 and {Jimenez 2014 @ 256} with 256 samples.",
      at = function(value) return { samples = value, truth = { samples = 1024 } } end,
    },
    list {
      name = "scale", title = "Scale of the scene", unit = "times all lengths", scale = "log", benign = 1,
      region = "inner", same_picture = true, values = { 1e-6, 1e-4, 0.01, 1, 100, 1e4, 1e6 }, shots = { "passage" },
      fixed = "The panel moves by 12.8 px. Its distance is 10 m at a scale of 1.",
      reading = "The error of adaptive is {adaptive @ 1e-06}, {adaptive @ 1} and {adaptive @ 1000000} " ..
                "at scales of 1e-6, 1 and 1e6. Methods compare ratios of depths, and transforms are relative to the " ..
                "camera. Therefore no constant of a method is a length.",
      at = function(value) return { ["scene.scale"] = value } end,
    },
    list {
      name = "offset", title = "Distance from the origin", unit = "m along each axis", scale = "log", benign = 0,
      region = "inner", same_picture = true,
      values = { 0, 1, 100, 1e4, 1e6, 1e7 }, shots = { "passage" },
      fixed = "Camera and scene are moved together. The panel moves by 12.8 px.",
      reading = "The error of adaptive is {adaptive @ 0} at the origin and {adaptive @ 10000000} at 10 000 " ..
                "km from it. Transforms of nodes are computed in double precision, relative to the camera, and then " ..
                "converted to single precision. Vertices that are far from the origin of their node are already rounded " ..
                "in the file.",
      at = function(value) return { ["scene.offset"] = value } end,
    },
    list {
      name = "gap", title = "Depth of the background", unit = "share of the front's depth, beyond it", scale = "log",
      benign = 0.5, region = "inner", same_picture = true,
      values = { 1e-6, 1e-4, 1e-3, 3e-3, 0.01, 0.03, 0.1, 0.5, 10, 100, 9999 },
      shots = { "passage" },
      fixed = "The panel moves by 12.8 px, 10 m away. The wall grows with its depth, so that the picture stays the same.",
      reading = "The rays of adaptive find the nearest surface, at any ratio of the depths. The error of adaptive " ..
                "is {adaptive @ 1e-06} if the background is farther by a millionth of the front's depth, and " ..
                "{adaptive @ 9999} if it is farther by ten thousand times that depth. Jimenez 2014 and UE4-style " ..
                "mirror colours only if the background is farther than the front by more than a hundredth of the depth " ..
                "(depth_extent). If the background is closer to the front than this, the error of Jimenez 2014 is " ..
                "{Jimenez 2014 @ 0.0001} instead of {Jimenez 2014 @ 0.5}. hybrid (text) reveals a background only at " ..
                "edges with a step of at least a twentieth of the depth. Below this step it equals McGuire 2012 bit for " ..
                "bit ({hybrid (text) @ 0.03}, {McGuire 2012 @ 0.03}).",
      at = function(value) return { ["scene.gap"] = value } end,
    },
    list {
      name = "angle", title = "Direction of motion", unit = "degrees from the horizontal", scale = "linear", benign = 0,
      region = "inner", values = { 0, 15, 30, 45, 60, 75, 90 },
      shots = { "passage" }, fixed = "The panel moves by 12.8 px.",
      reading = "The error of adaptive is {adaptive @ 0} along the rows, {adaptive @ 45} along the diagonal " ..
                "and {adaptive @ 90} along the columns, with floors of {floor @ 0}, {floor @ 45} and {floor @ 90}. " ..
                "The errors differ because each direction occludes and disoccludes other cells of wall and panel.",
      at = function(value) return { ["scene.angle"] = value } end,
    },
    list {
      name = "grazing", title = "Grazing angle of the moving surface", unit = "degrees between its normal and the view",
      scale = "even", benign = 0, region = "inner", same_picture = true,
      values = { 0, 30, 60, 75, 85, 88, 89.5, 89.9 },
      shots = { "grazing" },
      fixed = "A panel of 96 x 72 px rotates about the camera. The rotation moves its image by 8 px.",
      reading = "The depth of a panel that is nearly edge-on changes by up to a tenth from pixel to pixel. Such a " ..
                "panel is blurred as accurately as one that faces the camera. The error of adaptive is {adaptive @ " ..
                "0} at 0 degrees and {adaptive @ 89.9} at 89.9 degrees. The error of McGuire 2012 at these angles " ..
                "is {McGuire 2012 @ 0} and {McGuire 2012 @ 89.9}.",
      at = function(value) return { ["scene.tilt"] = value } end,
    },
    list { name = "velocity_format", title = "Displacements", shots = cases, benign = "fp32",
      values = { "fp32", "fp16" },
      reading = "With half floats, pixels of McGuire 2012 change by up to {change McGuire 2012, fp16 @ 12.8 px} at 12.8 " ..
                "px. The default is fp32." },
    list { name = "color_format", title = "Colours", shots = cases, benign = "fp32",
      values = { "fp32", "fp16" },
      reading = "With half floats at 12.8 px, pixels of hybrid (text) change by up to {change hybrid " ..
                "(text), fp16 @ 12.8 px}, and pixels of adaptive by up to {change adaptive, fp16 @ 12.8 px}. " ..
                "For the tilted panel the error of adaptive is so small that half floats increase it from {adaptive, " ..
                "fp32 @ tilted by 89.9 degrees} to {adaptive, fp16 @ tilted by 89.9 degrees}. The default is fp32 for " ..
                "exact measurements. Half floats for colours are the first choice to save memory." },
    list { name = "depth_encoding", title = "Depths", shots = cases, benign = "linear",
      values = { "linear", "reversed", "inverse", "unorm24" },
      reading = "The four encodings (linear, reversed, inverse, unorm24) all store a depth in 4 bytes. The default, " ..
                "linear, stores the depth unchanged, as a single-precision number." },
  } },
  skip = function(point)
    local varies_format = point.velocity_format or point.color_format or point.depth_encoding
    return varies_format and (point.arm == "no blur" or point.arm == "floor")
  end,
  expect = expected,
  layout = {
    curves = { factor = 2 },
    table = { title = "Formats of images between passes", axes = formats, cells = { "rmse", "change" },
              once = { "memory", "ms", "ms_least" }, share = true },
  },
}
