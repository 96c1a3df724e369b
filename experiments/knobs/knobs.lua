-- SPDX-License-Identifier: MIT
-- Changes one setting (knob) of the pipeline hybrid_traced at a time. Measures the time that the change saves, the error that
-- it adds, and the scenes that require the unchanged setting.
--   strobe sweep experiments/knobs/knobs.lua -o out/knobs
local experiment = require "strobe.experiment"

local moving = { "vase", "panel", "fan", "stacked", "tracking" }  -- the shots with motion

-- Knobs. Each replaces the pipeline, parameters of the pipeline (`set`) or options of the shot (`run`). `needed`: shots where
-- the change is expected to increase the error by more than a twentieth.
local knobs = {
  { name = "arcs", set = { trajectory = "arc" }, needed = {} },
  { name = "no rays at the sample times", pipeline = "hybrid_layered", needed = moving },
  { name = "every hit shaded", set = { ["trace_time_samples.same_depth"] = 0 }, needed = { "fan", "stacked" } },
  { name = "four samples", set = { samples = 4 }, needed = moving },
  { name = "64 samples", set = { samples = 64 }, needed = {} },
  { name = "tiles of 20 px", set = { tile = 20 }, needed = {} },
  { name = "each shadow ray traced", set = { ["tile_light_visibility.per_tile"] = false }, needed = {} },
  { name = "half floats", set = { color_format = "fp16", velocity_format = "fp16" }, needed = {} },
  { name = "no omission", run = { model_everything = true }, needed = {} },
  { name = "ray queries", run = { backend = "query" }, needed = {} },
  { name = "ray pipelines", run = { backend = "pipeline" }, needed = {} },
}
local plain, best, base = "as it is", "hybrid_traced", "McGuire 2012"

local arms, runs, ways = {
  { name = base, pipeline = "mcguire2012" },
  { name = best, pipeline = "hybrid_traced" },
}, { plain }, { [plain] = {} }
for _, knob in ipairs(knobs) do
  if not knob.run then
    arms[#arms + 1] = { name = knob.name, pipeline = knob.pipeline or "hybrid_traced", set = knob.set }
  else
    runs[#runs + 1], ways[knob.name] = knob.name, knob.run
  end
end

local shots = {
  { name = "still", title = "Living room without motion", scene = "living_room", camera = "main", ["scene.pixels"] = 0 },
  { name = "vase", title = "Living room, the vase slides", scene = "living_room", camera = "main", ["scene.pixels"] = 24 },
  { name = "panel", title = "A panel slides, unlit", scene = "stability/passage", ["scene.speed"] = 40,
    ["scene.angle"] = 17 },
  { name = "fan", title = "A fan behind its cage", scene = "objects/caged_fan" },
  { name = "stacked", title = "Four boxes, one behind another", scene = "objects/stacked" },
  { name = "tracking", title = "A camera follows a car", scene = "objects/tracking_parallax" },
}

local function at(r, shot, knob)
  return r.at { shot = shot, arm = (knob == plain or ways[knob]) and best or knob, run = ways[knob] and knob or plain }
end

-- Returns a measure with a knob changed, divided by this measure with all knobs unchanged; 1 if both are 0.
local function ratio(r, shot, knob, measure)
  local own, other = at(r, shot, knob)[measure], at(r, shot, plain)[measure]
  if other == 0 then return own == 0 and 1 or math.huge end
  return own / other
end

-- Returns a text with the least and the greatest ratio over all shots, for example "time 0.83 (fan) to 1.01 (still)".
local function range(r, knob, measure, what)
  local least, most, least_at, most_at = math.huge, -math.huge, "", ""
  for _, shot in ipairs(shots) do
    local value = ratio(r, shot.name, knob, measure)
    if value < least then least, least_at = value, shot.name end
    if value > most then most, most_at = value, shot.name end
  end
  return ("%s %.2f (%s) to %.2f (%s)"):format(what, least, least_at, most, most_at)
end

local function listed(found) return #found == 0 and "no shot" or table.concat(found, ", ") end

local expected = {}
for _, knob in ipairs(knobs) do
  expected[#expected + 1] = {
    ("%s: the error grows by more than a twentieth in %s"):format(knob.name, listed(knob.needed)), known = knob.known,
    function(r)
      local found = {}
      for _, shot in ipairs(shots) do
        if ratio(r, shot.name, knob.name, "rmse") > 1.05 then found[#found + 1] = shot.name end
      end
      return listed(found) == listed(knob.needed), ("%s, %s; in %s"):format(
        range(r, knob.name, "ms_ratio", "time"), range(r, knob.name, "rmse", "error"), listed(found))
    end }
end

return experiment {
  title    = "Knobs of cost",
  question = "How much time does each parameter save, how much error does it add, and which scenes require it?",
  note     = "Each arm or run changes one parameter of hybrid_traced. Times are ratios to McGuire 2012 with 16 " ..
             "samples in the same shot. The arms are timed in turn in one run. In the expectations, times and errors are " ..
             "ratios to the unchanged hybrid_traced.",
  size     = { 320, 180 },
  shots    = shots,
  arms     = arms,
  base     = base,
  truth    = { pipeline = "ground_truth", set = { samples = 256, times = "stratified" } },
  rounds   = 5,
  vary     = { experiment.list { name = "run", title = "Run", values = runs, at = function(name) return ways[name] end } },
  skip     = function(point) return point.run ~= plain and point.arm ~= best end,
  regions  = { "whole" },
  measures = { "rmse", "flip", "ms_ratio", "rays" },
  expect   = expected,
  layout   = { front = { x = "ms_ratio", y = "rmse", region = "whole" }, table = {} },
}
