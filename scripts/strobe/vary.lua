-- SPDX-License-Identifier: MIT
-- Axes of an experiment. An axis is a varied quantity, with a name and a list of values. This file makes axes and the
-- combinations of their values. The experiment is measured at each combination. docs/writing-experiments.md describes each kind
-- of axis.
local check     = require "strobe.check"
local native    = require "strobe.native"
local sequences = require "strobe.sequences"

local vary = {}

-- An element of the field `vary` of an experiment: some axes, and the way to combine their values. The function
-- `combine(entries)` returns the combinations of values. A combination is a list with one pair { axis, value } for each of its
-- axes: the index of the axis and the index of the value. `entries[axis][i]` is the value with the index `i` of an axis, as a
-- combination with only this pair.
local Varied = {}
local function varied(axes, combine) return setmetatable({ axes = axes, combine = combine }, Varied) end

function vary.is_varied(value) return getmetatable(value) == Varied end

-- Returns the Cartesian product of lists of combinations: each combination of the first list joined with each of the second
-- list, and so on. The last list varies fastest.
function vary.multiplied(lists)
  local product = { {} }
  for _, entries in ipairs(lists) do
    local longer = {}
    for _, before in ipairs(product) do
      for _, entry in ipairs(entries) do
        longer[#longer + 1] = table.move(entry, 1, #entry, #before + 1, { table.unpack(before) })
      end
    end
    product = longer
  end
  return product
end

-- Returns one axis for each name in the table `t`, { NAME = list }, sorted by name. `values_of(list, place, name)` returns the
-- values of the axis. `usage`: correct form of the call, for messages.
local function axes_of(t, place, usage, values_of)
  local axes = {}
  local names = type(t) == "table" and check.names(t) or {}
  table.sort(names)
  for i, name in ipairs(names) do
    local at = native.key_place(place, name)
    if type(t[name]) ~= "table" or #t[name] == 0 then
      check.fail(at, "'%s' is %s instead of a list: %s", name, type(t[name]) == "table" and "empty" or check.quoted(t[name]),
                 usage)
    end
    axes[i] = { fields = { name = name, values = values_of(t[name], at, name) }, place = at }
  end
  if #axes == 0 then check.fail(place, "no axis is given: %s", usage) end
  return axes
end

local function as_they_are(values) return values end

-- Returns a function `combine` that makes one combination for each row in `rows`. In the combination of a row, axis `k` has the
-- value with the index row[k]. Equal rows give one combination.
local function combined(axes, rows)
  return function(entries)
    local all, known = {}, {}
    for _, row in ipairs(rows) do
      local key, combination = table.concat(row, " "), {}
      for k, axis in ipairs(axes) do combination[k] = entries[axis][row[k]][1] end
      if not known[key] then all[#all + 1], known[key] = combination, true end
    end
    return all
  end
end

-- Returns the index of `value` in the list `values`, after appending it if it is not there. A float and an integer are
-- different values.
local function number_in(values, value)
  for i, known in ipairs(values) do
    if known == value and math.type(known) == math.type(value) then return i end
  end
  values[#values + 1] = value
  return #values
end

-- ---- values

local function check_count(place, what, count, least)
  if math.type(count) ~= "integer" or count < least then
    check.fail(place, "%s is called with the count %s; the count must be a whole number, at least %d", what,
               tostring(count), least)
  end
end

-- `linear(0, 1, 5)` returns 5 values from 0 to 1 with equal steps.
vary.linear = native.at_caller(function(place, from, to, count)
  check_count(place, "linear", count, 2)
  local values = {}
  for i = 0, count - 1 do values[i + 1] = from + (to - from) * i / (count - 1) end
  return values
end)

-- `log(0.01, 1, 5)` returns 5 values from 0.01 to 1 with equal ratios.
vary.log = native.at_caller(function(place, from, to, count)
  check_count(place, "log", count, 2)
  if not (from > 0 and to > 0) then check.fail(place, "the first and last value of log must be above 0") end
  local values = {}
  for i = 0, count - 1 do values[i + 1] = from * (to / from) ^ (i / (count - 1)) end
  values[count] = to + 0.0
  return values
end)

-- ---- combinations

-- `list { name = "speed", values = { 1, 2, 4 }, ... }` makes one axis. The table has the fields of the axis (experiment.lua).
vary.list = native.at_caller(function(place, t)
  if type(t) ~= "table" then check.fail(place, "list takes a table: list { name = ..., values = { ... } }") end
  local axis = { fields = t, place = place }
  return varied({ axis }, function(entries) return entries[axis] end)
end)

-- `grid { samples = { 4, 8 }, exposure = { 0.25, 0.5 } }` makes one axis for each name, with all combinations of their values.
-- The axes are sorted by name, and the last one varies fastest.
vary.grid = native.at_caller(function(place, t)
  local axes = axes_of(t, place, "grid { NAME = { values }, ... }", as_they_are)
  return varied(axes, function(entries)
    local lists = {}
    for i, axis in ipairs(axes) do lists[i] = entries[axis] end
    return vary.multiplied(lists)
  end)
end)

-- `zip { samples = { 4, 8 }, tile = { 20, 40 } }` makes one axis for each name. The first combination has the first value of
-- each axis, the second combination the second value of each, and so on.
vary.zip = native.at_caller(function(place, t)
  local axes, rows = axes_of(t, place, "zip { NAME = { values }, ... }", as_they_are), {}
  local count = #axes[1].fields.values
  for _, axis in ipairs(axes) do
    if #axis.fields.values ~= count then
      check.fail(axis.place, "zip needs lists of equal length, but got %d values of '%s' and %d of '%s'",
                 #axis.fields.values, axis.fields.name, count, axes[1].fields.name)
    end
  end
  for i = 1, count do
    rows[i] = {}
    for k = 1, #axes do rows[i][k] = i end
  end
  return varied(axes, combined(axes, rows))
end)

-- `each { list { ... }, grid { ... } }` lists the combinations of its first entry, then of its second entry, and so on. Entries
-- are not combined with each other: a point has only the axes of one entry.
vary.each = native.at_caller(function(place, t)
  local axes = {}
  for i, part in ipairs(type(t) == "table" and t or {}) do
    if not vary.is_varied(part) then check.fail(place, "entry %d of each is not a list, a grid or another axis", i) end
    table.move(part.axes, 1, #part.axes, #axes + 1, axes)
  end
  if #axes == 0 then check.fail(place, "each takes a list of axes: each { list { ... }, ... }") end
  return varied(axes, function(entries)
    local all = {}
    for _, part in ipairs(t) do
      local more = part.combine(entries)
      table.move(more, 1, #more, #all + 1, all)
    end
    return all
  end)
end)

-- `ablation({ samples = 16, tile = 40 }, { samples = { 4, 8 }, tile = { 20 } })` makes the combination of the first table, the
-- base, and then combinations that differ from the base in one value: here `samples` 4, `samples` 8 and `tile` 20.
vary.ablation = native.at_caller(function(place, base, changes)
  local usage = "ablation({ NAME = value, ... }, { NAME = { values }, ... })"
  if type(base) ~= "table" then check.fail(place, "ablation takes a base and its changes: %s", usage) end
  local changed = axes_of(changes, place, usage, as_they_are)
  for _, axis in ipairs(changed) do
    if base[axis.fields.name] == nil then
      check.fail(axis.place, "'%s' has changed values, but is not in the base of the ablation%s", axis.fields.name,
                 native.nearest(axis.fields.name, check.names(base)))
    end
  end
  local of_base, start, rows = {}, {}, {}
  for name, value in pairs(base) do of_base[name] = { value } end
  local axes = axes_of(of_base, place, usage, as_they_are)
  for k, axis in ipairs(axes) do start[k], axis.place = 1, place end
  rows[1] = start
  for k, axis in ipairs(axes) do
    for _, value in ipairs(changes[axis.fields.name] or {}) do
      local row = { table.unpack(start) }
      row[k] = number_in(axis.fields.values, value)
      rows[#rows + 1] = row
    end
  end
  return varied(axes, combined(axes, rows))
end)

-- ---- samples of a space

-- Returns the value of the list `range` at the position `u` in [0, 1):
--   two whole numbers                a whole number between them, both included
--   two other numbers                a number between them
--   texts, or more than two numbers  one of the entries
-- With range.log = true, values between two numbers are distributed evenly by their logarithm.
local function value_at(range, u)
  local from, to = range[1], range[2]
  if type(from) ~= "number" or #range ~= 2 then return range[1 + math.floor(u * #range)] end
  local whole = math.type(from) == "integer" and math.type(to) == "integer"
  local last = whole and to + 1 or to
  local value = range.log and from * (last / from) ^ u or from + (last - from) * u
  return whole and math.min(math.floor(value), to) or value
end

local function check_range(range, place, name)
  local numbers = #range == 2 and math.type(range[1]) and math.type(range[2])
  if numbers and range[1] >= range[2] then
    check.fail(place, "the range of '%s' is empty: %s to %s", name, range[1], range[2])
  end
  if range.log and (not numbers or range[1] <= 0) then
    check.fail(place, "the range of '%s' has log = true, so it must be two numbers above 0", name)
  end
  return {}
end

-- Returns axes with the names of the table `ranges`, for `random` and `sobol`. There is one combination for each point
-- that `points_of(dimensions)` returns. A point is in the unit cube, with one dimension per axis; each coordinate is a
-- position in the range of its axis.
local function spread(place, ranges, usage, points_of)
  local axes, rows = axes_of(ranges, place, usage, check_range), {}
  for i, point in ipairs(points_of(#axes)) do
    rows[i] = {}
    for k, axis in ipairs(axes) do
      rows[i][k] = number_in(axis.fields.values, value_at(ranges[axis.fields.name], point[k]))
    end
  end
  return varied(axes, combined(axes, rows))
end

-- `random(20, 1, { samples = { 1, 64 }, exposure = { 0.1, 1.0 } })` makes 20 random points from the seed 1, uniformly
-- distributed in the ranges.
vary.random = native.at_caller(function(place, count, seed, ranges)
  check_count(place, "random", count, 1)
  if math.type(seed) ~= "integer" then check.fail(place, "the seed of random must be a whole number") end
  return spread(place, ranges, "random(COUNT, SEED, { NAME = { from, to }, ... })", function(width)
    local next_number, points = sequences.random(seed), {}
    for i = 1, count do
      points[i] = {}
      for k = 1, width do points[i][k] = next_number() end
    end
    return points
  end)
end)

-- `sobol(20, { samples = { 1, 64 }, exposure = { 0.1, 1.0 } })` makes 20 points that fill the ranges evenly.
vary.sobol = native.at_caller(function(place, count, ranges)
  check_count(place, "sobol", count, 1)
  return spread(place, ranges, "sobol(COUNT, { NAME = { from, to }, ... })", function(width)
    if width > sequences.most_dimensions then
      check.fail(place, "sobol varies %d parameters; it can vary at most %d", width, sequences.most_dimensions)
    end
    return sequences.sobol(count, width)
  end)
end)

return vary
