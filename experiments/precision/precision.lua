-- SPDX-License-Identifier: MIT
-- Measures how error and memory depend on the number formats of the images between passes (half or single precision, encodings
-- of depth). Expected: half floats for colours change every error by less than a hundredth, depth encodings by less than a
-- thousandth.
--   strobe sweep experiments/precision/precision.lua -o out/precision
local experiment = require "strobe.experiment"

local list = experiment.list
local formats = { "velocity_format", "color_format", "both", "depth_encoding" }
local arms = { "hybrid", "McGuire 2012", "Guertin 2014", "Jimenez 2014" }
local shots = { "living_room", "textured_bar", "quad_2d", "wedge" }

-- Returns the test of an expectation: for each arm and shot, the error at each later value of `values` differs from the error
-- at the first value by less than the fraction `allowed` of this error.
local function steady(axis, values, allowed)
  return function(r)
    local most = 0
    for _, shot in ipairs(shots) do
      for _, arm in ipairs(arms) do
        local base = r.at { [axis] = values[1], arm = arm, shot = shot }.rmse
        for i = 2, #values do
          most = math.max(most, math.abs(r.at { [axis] = values[i], arm = arm, shot = shot }.rmse / base - 1))
        end
      end
    end
    return most < allowed, ("largest relative change %.2g"):format(most)
  end
end

local two, encodings = { "fp32", "fp16" }, { "linear", "reversed", "inverse", "unorm24" }

return experiment {
  title = "Precision of images between passes",
  question = "How much do half floats and depth encodings change errors, and how much memory do they save?",
  size = { 320, 180 },
  regions = { "whole" },
  measures = { "rmse", "change_rms", "change", "bytes" },
  arms = {
    { name = "hybrid", pipeline = "hybrid_layered", set = { limit = 10 } },
    { name = "McGuire 2012", pipeline = "mcguire2012", set = { limit = 10 } },
    { name = "Guertin 2014", pipeline = "guertin2014", set = { limit = 10 } },
    { name = "Jimenez 2014", pipeline = "jimenez2014", set = { limit = 10 } },
  },
  truth = { pipeline = "ground_truth", set = { samples = 256 } },
  shots = {
    { name = "living_room", scene = "living_room" },
    { name = "textured_bar", scene = "oracles/textured_bar", frame = 0, ["scene.width"] = 320, ["scene.height"] = 180 },
    { name = "quad_2d", scene = "oracles/quad_2d", frame = 0, ["scene.width"] = 320, ["scene.height"] = 180 },
    { name = "wedge", scene = "oracles/wedge", frame = 0, ["scene.width"] = 320, ["scene.height"] = 180 },
  },
  vary = { experiment.each {
    list { name = "velocity_format", title = "Displacements", benign = "fp32", values = two },
    list { name = "color_format", title = "Colours", benign = "fp32", values = two },
    list { name = "both", title = "Displacements and colours", benign = "fp32", values = two,
           at = function(value) return { velocity_format = value, color_format = value } end },
    list { name = "depth_encoding", title = "Depths", benign = "linear", values = encodings },
  } },
  expect = {
    { "half floats for colours change every error by less than a hundredth", steady("color_format", two, 0.01),
      axis = "color_format" },
    { "depth encodings change every error by less than a thousandth", steady("depth_encoding", encodings, 0.001),
      axis = "depth_encoding" },
  },
  layout = { table = { axes = formats, cells = { "rmse", "change_rms", "change" }, once = { "bytes" } } },
}
