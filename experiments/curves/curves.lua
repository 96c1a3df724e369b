-- SPDX-License-Identifier: MIT
-- Compares straight, parabolic and circular screen paths of surface points, by their errors for objects that turn or approach.
--   strobe sweep experiments/curves/curves.lua -o out/curves
local experiment = require "strobe.experiment"

-- Shots with objects that turn by less than a fifth of a turn within the exposure: all shots except "fan_200".
local shots = { "wheel", "fan", "pendulum", "nearer", "telescope" }
local curves = { "line", "quadratic", "arc" }

local function at(r, shot, arm, region) return r.at { shot = shot, arm = arm, region = region or "whole" } end

local function layers(curve) return "layers, " .. curve end

-- Returns the part of an arm's error e beyond the error of ground truth with as many samples (the floor): sqrt(e^2 - floor^2),
-- because the squares of independent errors add up.
local function beyond(r, shot, arm, region)
  local own, floor = at(r, shot, arm, region).rmse, at(r, shot, "truth, 16 samples", region).rmse
  return math.sqrt(math.max(own * own - floor * floor, 0))
end

local steps = "experiments/pipelines/hybrid_steps.lua"
local arms = {}
local function add(name, pipeline, set) arms[#arms + 1] = { name = name, pipeline = pipeline, set = set } end
for _, curve in ipairs(curves) do
  add(layers(curve), steps, { mask = "moving", trajectory = curve })
end
add("adaptive", "adaptive")
arms[#arms + 1] = { name = "truth, 16 samples", pipeline = "ground_truth", role = "floor",
  set = { samples = 16, times = "midpoint" } }

-- Returns the largest value of the function `of` over `shots`, and the name of the shot with this value.
local function largest(of)
  local most, where = 0, ""
  for _, shot in ipairs(shots) do
    local ratio = of(shot)
    if ratio > most then most, where = ratio, shot end
  end
  return most, where
end

return experiment {
  title    = "Curved paths",
  question = "How much error do curved paths save where objects turn or approach?",
  note     = "The arms \"layers\" use layers at the raster time alone. They reveal a background behind all moving surfaces, " ..
             "and each point moves along a line, a parabola or an arc. The arm adaptive does not model the paths of " ..
             "points: it traces rays at several times. The floor is the error of truth with as many samples. An " ..
             "error e beyond the floor f is sqrt(e^2 - f^2).",
  size     = { 320, 180 },
  size_params = { "width", "height" },
  shots    = {
    { name = "wheel", title = "A wheel rolls by 45 degrees", scene = "objects/spoked_wheel" },
    { name = "fan", title = "A fan behind its cage", scene = "objects/caged_fan" },
    { name = "fan_200", title = "The fan turns by more than half a turn", scene = "objects/caged_fan", ["scene.degrees"] = 200,
      ["scene.pixels"] = 260 },
    { name = "pendulum", title = "A pendulum", scene = "objects/pendulum" },
    { name = "nearer", title = "A box approaches by half its distance", scene = "objects/nearer" },
    { name = "telescope", title = "A telescope turns to the camera", scene = "objects/telescope" },
  },
  arms     = arms,
  truth    = { pipeline = "ground_truth", set = { samples = 256, times = "stratified" } },
  regions  = { "whole", "inner", "hidden", "outer", "self" },
  measures = { "rmse", "flip", "rays", "pixels" },
  expect   = {
    { "for wheel, fan, pendulum and approaching box, the error of arcs beyond the floor is at most half of the " ..
      "error of lines beyond the floor", function(r)
      local most, where = 0, ""
      for _, shot in ipairs { "wheel", "fan", "pendulum", "nearer" } do
        local ratio = beyond(r, shot, layers "arc") / beyond(r, shot, layers "line")
        if ratio > most then most, where = ratio, shot end
      end
      return most <= 0.5, ("at most %.2f (%s)"):format(most, where)
    end },
    { "up to a fifth of a turn, the error of arcs is at most 1.02 times the error of parabolas", function(r)
      local most, where = largest(function(shot)
        return at(r, shot, layers "arc").rmse / at(r, shot, layers "quadratic").rmse
      end)
      return most <= 1.02, ("at most %.3f times the error (%s)"):format(most, where)
    end },
    { "found afterwards: for a fan that turns by more than half a turn, the error of arcs beyond the floor is at " ..
      "most three quarters of the error of parabolas beyond the floor", function(r)
      local ratio = beyond(r, "fan_200", layers "arc") / beyond(r, "fan_200", layers "quadratic")
      return ratio <= 0.75, ("%.2f of the error of parabolas, %.2f of the error of lines"):format(ratio,
        beyond(r, "fan_200", layers "arc") / beyond(r, "fan_200", layers "line"))
    end },
    { "adaptive has a smaller error than layers with arcs, in every shot", function(r)
      local most, where = largest(function(shot)
        return at(r, shot, "adaptive").rmse / at(r, shot, layers "arc").rmse
      end)
      return most < 1, ("at most %.2f of the error (%s)"):format(most, where)
    end },
  },
  layout   = { table = {} },
}
