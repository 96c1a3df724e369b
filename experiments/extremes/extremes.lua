-- SPDX-License-Identifier: MIT
-- Where each method stops being trustworthy: error against truth along axes that each grow to an extreme.
--   strobe sweep experiments/extremes/extremes.lua -o out/extremes
local experiment = require "strobe.experiment"

local best = "hybrid (best)"
local formats = { "velocity_format", "color_format", "depth_encoding" }
local cases = { "12.8 px", "1 px", "31 px", "background 1e-6 beyond", "background 9999 beyond",
                "tilted by 89.9 degrees" }
local list, each = experiment.list, experiment.each

local arms = { "no blur", "McGuire 2012", "UE4-style", "Guertin 2014", "Jimenez 2014", "hybrid (to the letter)", best }
local scales = { 1e-6, 1e-4, 0.01, 1, 100, 1e4, 1e6 }
local offsets = { 0, 1, 100, 1e4, 1e6, 1e7 }

-- The error of an arm at a value of an axis.
local function error_at(r, axis, value, arm, region) return r.at { [axis] = value, arm = arm, region = region }.rmse end

-- `of(r)` is how much of what is allowed is reached: 1 is all of it.
local function expectation(axis, text, of)
  return { text, axis = axis, function(r)
    local most = of(r)
    return most <= 1, ("%.3f of what is allowed"):format(most)
  end }
end

-- The largest relative difference of `arm`'s errors along an axis from that at `benign`, in units of `allowed`.
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

-- The same for a format against its benign value, over every case and blur; `except` (arm, case) says what is left out.
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
local function slow_best(arm, case) return arm == best and case == "1 px" end

local speeds = { 0.01, 0.03, 0.1, 0.3, 0.6, 1, 2, 4, 8, 12.8, 15.5, 20, 31, 40, 64, 128, 320, 1280 }
local samples = { 1, 2, 4, 6, 8, 12, 16, 24, 32, 64, 128, 256 }

local expected = {
  expectation("speed", "up to 0.3 px every other method errs as much as no blur does", function(r)
    local most = 0
    for _, speed in ipairs { 0.03, 0.1, 0.3 } do
      local base = error_at(r, "speed", speed, "no blur", "whole")
      for i = 1, #arms - 1 do
        most = math.max(most, math.abs(error_at(r, "speed", speed, arms[i], "whole") / base - 1) / 1e-3)
      end
    end
    return most
  end),
  expectation("speed", "at every speed hybrid (best) errs by at most 1.3 times the floor", function(r)
    local most = 0
    for _, speed in ipairs(speeds) do
      local floor = error_at(r, "speed", speed, "floor", "whole")
      if floor > 0 then most = math.max(most, error_at(r, "speed", speed, best, "whole") / (1.3 * floor)) end
    end
    return most
  end),
  expectation("speed", "at 12.8 px every other method errs at least five times as much", function(r)
    local most, own = 0, error_at(r, "speed", 12.8, best, "whole")
    for i = 1, #arms - 1 do most = math.max(most, 5 * own / error_at(r, "speed", 12.8, arms[i], "whole")) end
    return most
  end),
  expectation("samples", "up to 64 samples hybrid (best) errs by at most 1.3 times the floor", function(r)
    local most = 0
    for _, count in ipairs(samples) do
      local floor = error_at(r, "samples", count, "floor", "inner")
      if count <= 64 then most = math.max(most, error_at(r, "samples", count, best, "inner") / (1.3 * floor)) end
    end
    return most
  end),
  expectation("samples", "beyond 64 samples hybrid (best) gains less than a hundredth", function(r)
    return 0.99 * error_at(r, "samples", 64, best, "inner") / error_at(r, "samples", 256, best, "inner")
  end),
  expectation("samples", "from 16 to 256 samples the other methods gain less than a hundredth", function(r)
    local most = 0
    for i = 1, #arms - 1 do
      local few, many = error_at(r, "samples", 16, arms[i], "inner"), error_at(r, "samples", 256, arms[i], "inner")
      most = math.max(most, 0.99 * few / many)
    end
    return most
  end),
  expectation("scale", "no method's error changes by a thousandth", all_drift("scale", scales, 1, 1e-3)),
  expectation("offset", "no method's error changes by a thousandth", all_drift("offset", offsets, 0, 1e-3)),
  expectation("gap", "hybrid (best) does not change by a thousandth, from a millionth to 9999 times", function(r)
    return drift(r, "gap", { 1e-6, 1e-4, 0.01, 10, 9999 }, 0.5, best, "inner", 1e-3)
  end),
  expectation("gap", "below a thirtieth of the depth hybrid (to the letter) is McGuire 2012", function(r)
    local most = 0
    for _, gap in ipairs { 1e-6, 1e-4, 1e-3, 3e-3, 0.01, 0.03 } do
      local base = error_at(r, "gap", gap, "McGuire 2012", "inner")
      most = math.max(most, math.abs(error_at(r, "gap", gap, "hybrid (to the letter)", "inner") / base - 1) / 1e-6)
    end
    return most
  end),
  expectation("gap", "a ten-thousandth behind Jimenez 2014 and UE4-style err a tenth more than at half the depth", function(r)
    local most = 0
    for _, arm in ipairs { "Jimenez 2014", "UE4-style" } do
      most = math.max(most, 1.1 * error_at(r, "gap", 0.5, arm, "inner") / error_at(r, "gap", 1e-4, arm, "inner"))
    end
    return most
  end),
  expectation("angle", "no direction changes the error of hybrid (best) by more than a third", function(r)
    return drift(r, "angle", { 15, 30, 45, 60, 75, 90 }, 0, best, "inner", 1 / 3)
  end),
  expectation("grazing", "the error of hybrid (best) does not grow by a thousandth up to 89.9 degrees", function(r)
    local most, facing = 0, error_at(r, "grazing", 0, best, "inner")
    for _, angle in ipairs { 30, 60, 75, 85, 88, 89.5, 89.9 } do
      most = math.max(most, (error_at(r, "grazing", angle, best, "inner") / facing - 1) / 1e-3)
    end
    return most
  end),
  expectation("velocity_format", "half floats change no error by a thousandth",
    format_drift("velocity_format", { "fp16" }, "fp32", 1e-3, nothing)),
  expectation("color_format", "half floats change no error by a five-hundredth, but hybrid (best) at 1 px",
    format_drift("color_format", { "fp16" }, "fp32", 2e-3, slow_best)),
  expectation("depth_encoding", "no encoding changes an error by a ten-thousandth",
    format_drift("depth_encoding", { "reversed", "inverse", "unorm24" }, "linear", 1e-4, nothing)),
}

return experiment {
  title = "Where each method stops being trustworthy",
  note = "Every method against ground truth of the same anchor and the same pixel centres, while one thing grows " ..
         "to an extreme and all else stays. 16 samples per pixel for every method unless the axis says " ..
         "otherwise; one sample per pixel.",
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
    { name = "hybrid (to the letter)", pipeline = "hybrid", set = { preset = "text" } },
    { name = "hybrid (best)", pipeline = "hybrid_traced" },
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
      fixed = "A panel of 96 x 72 px moves to the right before a wall at 1.5 times its depth.",
      reading = "Up to half a pixel filters copy what the capture saw: at 0.3 px UE4-style errs by {UE4-style @ 0.3} of the " ..
                "contrast, as no blur does. The capture has one sample per pixel, so no filter knows where in its pixel " ..
                "an edge lies, and edges move in steps of a whole pixel: {UE4-style @ 1} at 1 px. Rays do: hybrid " ..
                "(best) errs by {hybrid (best) @ 0.3} at 0.3 px, {hybrid (best) @ 1} at 1 px and {hybrid (best) @ " ..
                "12.8} at 12.8 px, with floors of {floor @ 0.3}, {floor @ 1} and {floor @ 12.8}: it is as good as its " ..
                "samples allow. The others err by {Jimenez 2014 @ 12.8} to {McGuire 2012 @ 12.8} there, nearly all of " ..
                "it inside the leading edge: Jimenez 2014 and UE4-style show what is mirrored from beside it, " ..
                "McGuire 2012, Guertin 2014 and hybrid (to the letter) leave the panel nearly opaque there. " ..
                "Nothing is shortened: at 40 px hybrid (best) errs by {hybrid (best) @ 40}, at 128 px by {hybrid (best) @ " ..
                "128}, where no blur errs by {no blur @ 128}.",
      at = function(value) return { ["scene.speed"] = value } end,
    },
    list {
      name = "samples", title = "Samples", unit = "per pixel", scale = "log", benign = 16, region = "inner",
      values = samples,
      shots = { "passage" },
      fixed = "The panel moves by 12.8 px. Truth at a method's own samples has as many as the method.",
      reading = "hybrid (best) follows the floor up to 64 samples ({hybrid (best) @ 64}, floor {floor @ 64}) and " ..
                "gains nothing beyond: at 256 it errs by {hybrid (best) @ 256} where the floor is {floor @ " ..
                "256} and truth's own error {truth @ 256}, as rays at their own time have 64 times at most. The others " ..
                "do not get better with samples, since " ..
                "their error is what they show and not how often they look: Jimenez 2014 has {Jimenez 2014 @ 16} " ..
                "with 16 and {Jimenez 2014 @ 256} with 256.",
      at = function(value) return { samples = value, truth = { samples = 1024 } } end,
    },
    list {
      name = "scale", title = "Scale of the scene", unit = "times all lengths", scale = "log", benign = 1,
      region = "inner", same_picture = true, values = { 1e-6, 1e-4, 0.01, 1, 100, 1e4, 1e6 }, shots = { "passage" },
      fixed = "The panel moves by 12.8 px. At 1 it is 10 m away.",
      reading = "hybrid (best) errs by {hybrid (best) @ 1e-06}, {hybrid (best) @ 1} and {hybrid (best) @ " ..
                "1000000}. Depths are compared as shares of each other and transforms are relative to the " ..
                "camera, so no constant of a method is a length.",
      at = function(value) return { ["scene.scale"] = value } end,
    },
    list {
      name = "offset", title = "Distance from the origin", unit = "m along each axis", scale = "log", benign = 0,
      region = "inner", same_picture = true,
      values = { 0, 1, 100, 1e4, 1e6, 1e7 }, shots = { "passage" },
      fixed = "Camera and scene are moved together. The panel moves by 12.8 px.",
      reading = "hybrid (best) errs by {hybrid (best) @ 0} at the origin and {hybrid (best) @ 10000000} 10 000 " ..
                "km from it. Transforms are made in double precision and relative to the camera before they " ..
                "become single. This is about where things are placed, not about vertices that are themselves " ..
                "written far from their node: these are rounded in the file.",
      at = function(value) return { ["scene.offset"] = value } end,
    },
    list {
      name = "gap", title = "Depth of the background", unit = "share of the front's depth, beyond it", scale = "log",
      benign = 0.5, region = "inner", same_picture = true,
      values = { 1e-6, 1e-4, 1e-3, 3e-3, 0.01, 0.03, 0.1, 0.5, 10, 100, 9999 },
      shots = { "passage" },
      fixed = "The panel moves by 12.8 px, 10 m away. The wall grows with its depth, so that it looks the same.",
      reading = "hybrid (best) asks depths only which of two surfaces is nearer, and instances for the rest: " ..
                "{hybrid (best) @ 1e-06} at a millionth, {hybrid (best) @ 9999} at ten thousand times. Jimenez " ..
                "2014 and UE4-style mirror the background only from what is clearly behind: below a hundredth of " ..
                "the depth (depth_extent) they no longer do, and err by {Jimenez 2014 @ 0.0001} instead of " ..
                "{Jimenez 2014 @ 0.5}. hybrid (to the letter) wants an edge of a twentieth of the depth before it " ..
                "reveals anything; below it reveals nothing and is McGuire 2012 bit for bit ({hybrid (to " ..
                "the letter) @ 0.03}, {McGuire 2012 @ 0.03}).",
      at = function(value) return { ["scene.gap"] = value } end,
    },
    list {
      name = "angle", title = "Direction of motion", unit = "degrees from the horizontal", scale = "linear", benign = 0,
      region = "inner", values = { 0, 15, 30, 45, 60, 75, 90 },
      shots = { "passage" }, fixed = "The panel moves by 12.8 px.",
      reading = "hybrid (best) errs by {hybrid (best) @ 0} along the rows, {hybrid (best) @ 45} along the " ..
                "diagonal and {hybrid (best) @ 90} along the columns, with floors of {floor @ 0}, {floor @ 45} " ..
                "and {floor @ 90}. What changes is which cells of wall and panel are hidden and shown.",
      at = function(value) return { ["scene.angle"] = value } end,
    },
    list {
      name = "grazing", title = "Grazing angle of the moving surface", unit = "degrees between its normal and the view",
      scale = "even", benign = 0, region = "inner", same_picture = true,
      values = { 0, 30, 60, 75, 85, 88, 89.5, 89.9 },
      shots = { "grazing" },
      fixed = "A panel of 96 x 72 px turns about the eye by 8 px.",
      reading = "A panel that is seen nearly edge on, whose depth changes by up to a tenth of itself from pixel " ..
                "to pixel, is blurred as well as one that faces the camera: hybrid (best) errs by {hybrid (best) " ..
                "@ 0} facing and by {hybrid (best) @ 89.9} at 89.9 degrees, McGuire 2012 by {McGuire 2012 @ 0} " ..
                "and {McGuire 2012 @ 89.9}.",
      at = function(value) return { ["scene.tilt"] = value } end,
    },
    list { name = "velocity_format", title = "Displacements", shots = cases, benign = "fp32",
      values = { "fp32", "fp16" },
      reading = "Pixels of McGuire 2012 change by up to {change McGuire 2012, fp16 @ 12.8 px} at 12.8 px. The default is " ..
                "fp32." },
    list { name = "color_format", title = "Colours", shots = cases, benign = "fp32",
      values = { "fp32", "fp16" },
      reading = "Pixels of hybrid (to the letter) change by up to {change hybrid (to the letter), fp16 @ 12.8 px}, " ..
                "those of hybrid (best) by {change hybrid (best), fp16 @ 12.8 px}. At 1 px its error is so small that half " ..
                "floats show in it: {hybrid (best), fp16 @ 1 px} instead of {hybrid (best), fp32 @ 1 px}. The default is " ..
                "fp32, since " ..
                "pictures are measured here; where memory counts, this is the first to give up." },
    list { name = "depth_encoding", title = "Depths", shots = cases, benign = "linear",
      values = { "linear", "reversed", "inverse", "unorm24" },
      reading = "All four are 4 bytes per pixel. The default is linear, which rounds nothing." },
  } },
  skip = function(point)
    local varies_format = point.velocity_format or point.color_format or point.depth_encoding
    return varies_format and (point.arm == "no blur" or point.arm == "floor")
  end,
  expect = expected,
  layout = {
    curves = { factor = 2 },
    table = { title = "Numbers between passes", axes = formats, cells = { "rmse", "change" },
              once = { "memory", "ms", "ms_least" }, share = true },
  },
}
