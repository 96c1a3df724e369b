-- SPDX-License-Identifier: MIT
-- Varies 11 parameters of the hybrid at once, in 64 points (settings of all parameters). Reports the Pareto front of error
-- against time, and the effect of each parameter. The points follow a Sobol sequence, so that the values of most parameters
-- are combined nearly evenly. The exception is `termination` with `weights`: each termination has points with two of the four
-- weights only.
local experiment = require "strobe.experiment"
local sequences = require "strobe.sequences"

-- Reasons why some of the expectations below failed; reports print these reasons.
local gather = "the composite in_gather is as good as layered in this shot, because only the vase moves"

local count = 64
local knobs = {
  { "samples", { 4, 8, 16, 32 } },
  { "tile", { 10, 20, 40 } },
  { "mask", { "none", "paper", "disocclusion", "moving" } },
  { "edge", { "sobel", "id" } },
  { "termination", { "luminance", "geometry", "instance", "motion" } },
  { "advance", { "restart", "origin_kept", "instance_filter" } },
  { "on_cap", { "fallback", "last_hit" } },
  { "tiles", { "separate", "union" } },
  { "composite", { "alpha_over", "in_gather", "layered" } },
  { "weights", { "mcguire2012", "guertin2014", "jimenez2014", "uniform" } },
  { "jitter", { "none", "ign" } },
}

-- Values of each parameter (knob), one per point: lists of equal length for experiment.zip, which takes their values in step.
local values, names = {}, {}
for k, knob in ipairs(knobs) do values[knob[1]], names[k] = {}, knob[1] end
-- None of the first `count` points of a plain Sobol sequence has both a tile size of 20 px and `tiles` = separate. So take a
-- sequence with twice as many points and one more dimension, number 8. Keep the points with coordinate 8 below 1/2, and
-- remove this coordinate. Each other coordinate of the kept points is as evenly spread as in the plain sequence.
for _, point in ipairs(sequences.sobol(2 * count, #knobs + 1)) do
  if table.remove(point, 8) < 0.5 then
    for k, knob in ipairs(knobs) do table.insert(values[knob[1]], knob[2][1 + math.floor(point[k] * #knob[2])]) end
  end
end

local function is_first(at)
  for _, name in ipairs(names) do
    if at[name] ~= values[name][1] then return false end
  end
  return true
end

local function point(i)
  local wanted = { arm = "hybrid", region = "inner" }
  for _, knob in ipairs(knobs) do wanted[knob[1]] = values[knob[1]][i] end
  return wanted
end

-- Returns the indices of the points on the Pareto front, and all points. A point is not on the front if another point is at
-- least as good in error and in time, and better in one of the two.
local function front(r)
  local all, on = {}, {}
  for i = 1, count do all[i] = r.at(point(i)) end
  for i, own in ipairs(all) do
    local beaten = false
    for _, other in ipairs(all) do
      local as_good = other.rmse <= own.rmse and other.ms_ratio <= own.ms_ratio
      beaten = beaten or as_good and (other.rmse < own.rmse or other.ms_ratio < own.ms_ratio)
    end
    if not beaten then on[#on + 1] = i end
  end
  return on, all
end

-- Returns the number of points on the front with each value of a knob, and a text with these numbers.
local function on_front(r, name)
  local on, counts, texts, order = front(r), {}, {}, {}
  for _, knob in ipairs(knobs) do if knob[1] == name then order = knob[2] end end
  for _, i in ipairs(on) do counts[values[name][i]] = (counts[values[name][i]] or 0) + 1 end
  for n, value in ipairs(order) do texts[n] = ("%s %d"):format(value, counts[value] or 0) end
  return counts, ("of %d points on the front: %s"):format(#on, table.concat(texts, ", "))
end

-- Returns the effect of a knob, and a text with all means. For each value of the knob, the mean error is the geometric mean of
-- the errors in the region inner, over all points with this value. The effect is the largest mean error divided by the least.
local function effect(r, name, order)
  local texts, least, most = {}, math.huge, 0
  for n, value in ipairs(order) do
    local log_error, time, number = 0, 0, 0
    for i = 1, count do
      if values[name][i] == value then
        local at = r.at(point(i))
        log_error, time, number = log_error + math.log(at.rmse), time + at.ms_ratio, number + 1
      end
    end
    local error = math.exp(log_error / number)
    least, most = math.min(least, error), math.max(most, error)
    texts[n] = ("%s %.4f at %.2f"):format(value, error, time / number)
  end
  return most / least, table.concat(texts, ", ")
end

local expected = {
  { "no setting without rays has a smaller error than the median of the settings with a disocclusion mask", function(r)
    local none, relative = math.huge, {}
    for i = 1, count do
      local error = r.at(point(i)).rmse
      if values.mask[i] == "none" then none = math.min(none, error) end
      if values.mask[i] == "disocclusion" then relative[#relative + 1] = error end
    end
    table.sort(relative)
    local median = relative[#relative // 2 + 1]
    return none > median, ("the least without rays is %.4f, the median with the disocclusion mask %.4f"):format(none, median)
  end },
  { "most settings on the front use rays: at most a third are without rays", function(r)
    local counts, text = on_front(r, "mask")
    local sum = 0
    for _, number in pairs(counts) do sum = sum + number end
    return (counts.none or 0) <= sum / 3, text
  end },
  { "no setting with rays on the front has both the published termination, by luminance, and an advance from hit to " ..
    "hit",
    function(r)
    local found = 0
    for _, i in ipairs((front(r))) do
      if values.mask[i] ~= "none" and values.termination[i] == "luminance" and values.advance[i] ~= "instance_filter" then
        found = found + 1
      end
    end
    local _, text = on_front(r, "termination")
    return found == 0, ("%d such settings; %s"):format(found, text)
  end },
  { "the setting with the least error has the composite layered and a termination other than luminance", known = gather,
    function(r)
    local least, who = math.huge, 1
    for i = 1, count do
      local error = r.at(point(i)).rmse
      if error < least then least, who = error, i end
    end
    local parts = {}
    for k, knob in ipairs(knobs) do parts[k] = ("%s %s"):format(knob[1], values[knob[1]][who]) end
    return values.composite[who] == "layered" and values.termination[who] ~= "luminance",
      ("RMSE %.4f with %s"):format(least, table.concat(parts, ", "))
  end },
  { "on the front the first increase of time gains most: some setting takes at most 0.1 times McGuire's time longer " ..
    "than the fastest setting, and has at most half of its error",
    function(r)
      local on, all = front(r)
      table.sort(on, function(a, b) return all[a].ms_ratio < all[b].ms_ratio end)
      local texts, fastest, good = {}, all[on[1]], false
      for n, i in ipairs(on) do
        texts[n] = ("%.4f at %.2f"):format(all[i].rmse, all[i].ms_ratio)
        good = good or all[i].rmse <= fastest.rmse / 2 and all[i].ms_ratio <= fastest.ms_ratio + 0.1
      end
      return good, "RMSE at a time: " .. table.concat(texts, ", ")
    end },
}

-- Adds the expectation that the mean errors of a knob's values differ by a factor of at least `factor`.
local function matters(name, factor)
  for _, knob in ipairs(knobs) do
    if knob[1] == name then
      expected[#expected + 1] = {
        ("%s matters: mean errors of its values differ by a factor of at least %g"):format(name, factor), function(r)
          local ratio, text = effect(r, name, knob[2])
          return ratio >= factor, ("%.2f; error at time: %s"):format(ratio, text)
        end }
    end
  end
end

-- Adds the expectation that the mean errors of a knob's values differ by less than a factor of `factor`.
local function hardly_matters(name, factor, known)
  for _, knob in ipairs(knobs) do
    if knob[1] == name then
      expected[#expected + 1] = {
        ("%s hardly matters: mean errors of its values differ by a factor below %g"):format(name, factor), known = known,
        function(r)
          local ratio, text = effect(r, name, knob[2])
          return ratio < factor, ("%.2f; error at time: %s"):format(ratio, text)
        end }
    end
  end
end

matters("mask", 1.5)
matters("termination", 1.3)
matters("composite", 1.3)
matters("weights", 1.1)
matters("samples", 1.1)
matters("advance", 1.1)
hardly_matters("tile", 1.15, "64 points do not fully average out the other parameters: varied alone, the tile size " ..
  "changes the error less (experiment `samples`)")
for _, name in ipairs { "edge", "on_cap", "tiles", "jitter" } do hardly_matters(name, 1.15) end

return experiment {
  title    = "Everything",
  question = "Which settings of the hybrid are on the front of error against time, and which parameters matter?",
  note     = ("%d settings of 11 parameters of the hybrid, spread evenly by the Sobol sequence, and the post-process "):format(
             count) .. "methods. The living room's vase slides past the cushions by 24 px. Times are ratios to McGuire 2012 " ..
             "with 16 samples. The mean error of a parameter's value is the geometric mean over all settings with this value.",
  size     = { 320, 180 },
  size_params = { "width", "height" },
  shots    = { { name = "vase", title = "Living room", scene = "living_room", camera = "main", ["scene.pixels"] = 24 } },
  arms     = {
    { name = "McGuire 2012", pipeline = "mcguire2012", lacks = names },
    { name = "UE4-style", pipeline = "ue4", set = { limit = 0.1 }, lacks = names },
    { name = "hybrid", pipeline = "experiments/pipelines/hybrid_steps.lua" },
  },
  base     = "McGuire 2012",
  truth    = { pipeline = "ground_truth", set = { samples = 256, times = "stratified" } },
  rounds   = 5,
  vary     = { experiment.zip(values) },
  skip     = function(at) return at.arm ~= "hybrid" and not is_first(at) end,
  regions  = { "whole", "inner" },
  measures = { "rmse", "flip", "ms_ratio", "masked" },
  expect   = expected,
  layout   = { front = { x = "ms_ratio", y = "rmse", region = "inner" }, table = {} },
}
