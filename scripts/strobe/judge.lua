-- SPDX-License-Identifier: MIT
-- Tests of the expectations of an experiment. An expectation is a text with a function `function(r) ... end`, which returns
-- true if the expectation holds. The argument `r` gives access to the results of the experiment.
local check  = require "strobe.check"
local native = require "strobe.native"
local shown  = require "strobe.fields".shown

local judge = {}

-- The results of an experiment. The method `at(place, wanted)` returns the mean of each measure over the points that match
-- `wanted`, a table with any of the fields `arm`, `shot`, `region` and the names of axes. An expectation passes only this
-- table: `r.at { arm = "hybrid", samples = 16 }`. The function `r.at` adds `place`, the line of this call, for error messages.
local Results = {}
Results.__index = Results

-- Raises an error about an unknown name in an expectation. `place`: the line that contains the name.
local function mistaken(place, text, ...) error({ mistake = text:format(...), place = place }, 0) end

local function require_known(place, name, allowed_names, what)
  if not check.contains(allowed_names, name) then
    mistaken(place, "unknown %s '%s'%s", what, tostring(name), native.nearest(tostring(name), allowed_names))
  end
end

function Results:names(entries)
  local names = {}
  for i, entry in ipairs(self.data[entries]) do names[i] = entry.name end
  return names
end

function Results:check(place, wanted)
  for _, key in ipairs(check.names(wanted)) do
    local value = wanted[key]
    if key == "arm" then require_known(place, value, self:names("arms"), "arm")
    elseif key == "shot" then require_known(place, value, self:names("shots"), "shot")
    elseif key == "region" then require_known(place, value, self.data.regions, "region")
    else
      require_known(place, key, self:names("axes"), "axis")
      self:known_value(place, key, value)
    end
  end
end

function Results:known_value(place, name, value)
  for _, axis in ipairs(self.data.axes) do
    if axis.name == name and not check.contains(axis.values, value) then
      mistaken(place, "axis '%s' has no value %s", name, shown(value))
    end
  end
end

local of_point = { arm = true, region = true }

local function group_matches(group, wanted)
  for key, value in pairs(wanted) do
    local is = group.at[key]
    if key == "shot" then is = group.shot end
    if not of_point[key] and is ~= value then return false end
  end
  return true
end

-- True if the point belongs to the arm with the name `arm`. Without `arm`, true if the arm of the point has the role "method".
local function point_matches(point, arm)
  if arm == nil then return point.role == "method" end
  return point.arm == arm
end

function Results:at(place, wanted)
  self:check(place, wanted)
  local sums, counts, region = {}, {}, wanted.region or "whole"
  for _, group in ipairs(self.data.groups) do
    for _, point in ipairs(group_matches(group, wanted) and group.points or {}) do
      for name, values in pairs(point_matches(point, wanted.arm) and point.values or {}) do
        local value = values[region]
        if value == nil then value = values.all end
        if value ~= nil then sums[name], counts[name] = (sums[name] or 0) + value, (counts[name] or 0) + 1 end
      end
    end
  end
  local means, known = { count = 0 }, self.known_measures
  for name, sum in pairs(sums) do means[name] = sum / counts[name] end
  for _, count in pairs(counts) do means.count = math.max(means.count, count) end
  return setmetatable(means, { __index = native.at_caller(function(line, _, name)
    require_known(line, name, known, "measure")
    if check.contains(self.data.incomparable or {}, name) then
      error({ unmeasured = ("values of '%s' come from several devices"):format(name), incomparable = true, place = line }, 0)
    end
    error({ unmeasured = ("no value of '%s' was measured for %s"):format(name, self.shown(wanted)), place = line }, 0)
  end) })
end

function Results.shown(wanted)
  local parts, names = {}, check.names(wanted)
  table.sort(names)
  for i, name in ipairs(names) do parts[i] = ("%s = %s"):format(name, shown(wanted[name])) end
  return #parts > 0 and table.concat(parts, ", ") or "anything"
end

local function is_missing(data, name)
  for _, shot in ipairs(data.shots) do if shot.name == name then return shot.missing end end
end

local function judged(entry, r, data)
  local outcome = { text = entry[1], shot = entry.shot, axis = entry.axis, outcome = "does not apply" }
  if entry.shot and is_missing(data, entry.shot) then return outcome end
  local good, holds, detail = pcall(entry[2], r)
  outcome.known = entry.known
  if not good and type(holds) == "table" and not holds.unmeasured then
    outcome.outcome, outcome.detail = "fails", holds.mistake or holds.problems and holds.problems[1].message
  elseif not good and type(holds) == "table" then
    outcome.outcome, outcome.detail = "fails", holds.unmeasured
    if data.partial or data.missing or holds.incomparable then outcome.outcome = "does not apply" end
  elseif not good then
    outcome.outcome, outcome.detail = "fails", tostring(holds)
  elseif holds ~= nil then
    outcome.outcome = holds and "holds" or "fails"
  end
  if good then outcome.detail = detail and tostring(detail) end
  return outcome
end

local record = check.record "r"

-- Returns the argument `r` for the functions of expectations. `data`: the results of the experiment. `known.measures`: the
-- names of all measures.
local function results_of(data, known)
  local results = setmetatable({ data = data, known_measures = known.measures }, Results)
  return record { at = native.at_caller(function(place, wanted) return results:at(place, wanted) end) }
end

-- Tests the expectations on the results `data` of their experiment, and returns the list of the outcomes: "holds", "fails" or
-- "does not apply", each with the text of the expectation. An expectation is { text, function, shot =, axis =, known = }.
-- `known.measures`: the names of all measures.
function judge.outcomes(expectations, data, known)
  local r, outcomes = results_of(data, known), {}
  for i, entry in ipairs(expectations) do outcomes[i] = judged(entry, r, data) end
  return outcomes
end

-- Adds a mistake for each expectation that contains an unknown arm, shot, region, axis, value or measure. To find such mistakes
-- before anything is rendered, this function calls the function of each expectation with placeholder results: each measure is 1
-- in `data`. The results of these calls are ignored.
function judge.rehearse(problems, expectations, data, known)
  local r = results_of(data, known)
  for _, entry in ipairs(expectations) do
    local good, failure = pcall(entry[2], r)
    if not good and type(failure) == "table" then
      local first = failure.problems and failure.problems[1] or failure
      problems:add(first.place, "expectation '%s': %s", entry[1], first.mistake or first.unmeasured or first.message)
    end
  end
end

return judge
