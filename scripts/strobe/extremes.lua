-- SPDX-License-Identifier: MIT
-- Experiments of extremes: methods, and axes along each of which one thing grows to an extreme; `strobe bench --extremes`
-- renders every method at every value, measures it against truth there and draws curves. `extremes { ... }` checks
-- everything below it, all mistakes at once, and returns it as plain data.
local check  = require "strobe.check"
local fields = require "strobe.fields"
local native = require "strobe.native"

local extremes = {}

local text, number, bool, list, map = fields.text, fields.number, fields.bool, fields.list, fields.map
local func, shown, settings, copied = fields.func, fields.shown, fields.settings, fields.copied

extremes.fields = {
  -- size_params: what the scenes call width and height of the picture. factor: a method is as good as its samples allow
  -- where its error is at most so many times the floor.
  experiment = {
    title = { text }, note = { text, optional = true }, size = { list, optional = true },
    size_params = { list, optional = true }, factor = { number },
    truth = { map }, floor = { map }, methods = { list }, axes = { list },
    variants = { list, optional = true }, cases = { list, optional = true },
  },
  -- truth and floor (truth at a method's own samples): a pipeline and its settings.
  truth = { label = { text }, pipeline = { text }, set = { map, optional = true } },
  floor = { label = { text }, pipeline = { text }, set = { map, optional = true } },
  -- lacks: settings of axes that the pipeline does not have and that are not given to it.
  method = {
    label = { text }, pipeline = { text }, set = { map, optional = true }, lacks = { list, optional = true },
  },
  -- at: what a value sets, as a function of it (fields of `point`). benign: the value, one of `values`, from which
  -- stops are counted. region: of truth, in which the curve is measured. same_picture: what is seen does not depend on
  -- the value, so truth must not change either. reading: what the curves say; {LABEL @ VALUE} is replaced by that error.
  axis = {
    name = { text }, title = { text }, unit = { text }, scale = { text }, values = { list }, benign = { number },
    scene = { text }, region = { text }, at = { func }, fixed = { text }, same_picture = { bool, optional = true },
    note = { text, optional = true }, reading = { text, optional = true },
  },
  -- A choice parameter of every pipeline that does not lack it: each of `values` is held against truth and against
  -- `reference`, which is one of them, in every one of the `cases`; its images are counted and its frames timed.
  -- reading: {LABEL, VALUE @ CASE} is replaced by that error, with "change " before it by the largest difference.
  variant = {
    name = { text }, title = { text }, reference = { text }, values = { list }, reading = { text, optional = true },
  },
  case = { label = { text }, scene = { text }, set = { map, optional = true } },
  -- What a value sets: parameters of the scene, of every pipeline, of truth and floor alone; options of the shot.
  point = {
    scene = { map, optional = true }, set = { map, optional = true }, truth = { map, optional = true },
    floor = { map, optional = true }, shot = { map, optional = true },
  },
}

extremes.regions = { "whole", "inner", "hidden", "outer" }
-- Where a value is drawn: by its logarithm (0 has a place of its own), by itself, or each as far from the next.
extremes.scales = { "log", "linear", "even" }

local Checker = fields.checker(extremes.fields)

function Checker:column(t, kind, path, what)
  local result = copied(self:fields(t, kind, path, what))
  result.set = settings(result.set)
  return result
end

function Checker:point(axis, value, path)
  local good, t = pcall(axis.at, value)
  if not good then
    local problem = type(t) == "table" and t.message or tostring(t)
    self:add(check.joined(path, "at"), "at(%s) of axis '%s' fails: %s", shown(value), axis.name, problem)
    return nil
  end
  t = self:fields(t, "point", check.joined(path, "at"), ("what at(%s) of axis '%s' returns"):format(shown(value), axis.name))
  local result = { value = value, label = shown(value) }
  for kind in pairs(extremes.fields.point) do result[kind] = settings(t[kind]) end
  return result
end

function Checker:values(axis, path)
  local points, before = {}, nil
  if #axis.values < 2 then self:add(check.joined(path, "values"), "an axis has at least two values") end
  for i, value in ipairs(axis.values) do
    local at = check.joined(check.joined(path, "values"), i)
    if type(value) ~= "number" or value ~= value or value == math.huge or value == -math.huge then
      self:add(at, "value %d is no finite number", i)
      return points
    end
    if before and value <= before then self:add(at, "values grow; %s follows %s", shown(value), shown(before)) end
    if axis.scale == "log" and value < 0 then self:add(at, "%s has no logarithm", shown(value)) end
    before = value
    points[#points + 1] = self:point(axis, value, path)
  end
  if not check.contains(axis.values, axis.benign) then
    self:add(check.joined(path, "benign"), "benign is %s, which is none of the values", shown(axis.benign))
  end
  return points
end

function Checker:axis(t, i)
  local path = { "axes", i }
  local before = #self.problems.list
  t = self:fields(t, "axis", path, "axis " .. i)
  self:one_of(t.scale, extremes.scales, check.joined(path, "scale"), "the scale of an axis")
  self:one_of(t.region, extremes.regions, check.joined(path, "region"), "the region of an axis")
  if t.name ~= nil and not check.is_name(t.name) then
    self:add(check.joined(path, "name"), "%s is not a name (a-z, then a-z, 0-9 and _)", check.quoted(t.name))
  end
  local result = copied(t)
  result.at, result.values = nil, nil
  if #self.problems.list == before then result.points = self:values(t, path) end
  return result
end

function Checker:variant(t, i)
  t = self:fields(t, "variant", { "variants", i }, "variant " .. i)
  if type(t.values) == "table" and t.reference ~= nil and not check.contains(t.values, t.reference) then
    local near = native.nearest(tostring(t.reference), t.values)
    self:add({ "variants", i, "reference" }, "the reference is '%s', none of the values%s", tostring(t.reference), near)
  end
  return copied(t)
end

function Checker:distinct(entries, key, group)
  local seen = {}
  for i, entry in ipairs(entries) do
    local name = entry[key]
    if name ~= nil and check.contains(seen, name) then
      self:add({ group, i, key }, "another of the %s is called '%s'", group, tostring(name))
    end
    seen[#seen + 1] = name
  end
end

local function checked(place, t)
  local self = Checker.at(place)
  if type(t) ~= "table" then check.fail(place, "extremes wants a table: extremes { ... }") end
  self:fields(t, "experiment", {})
  local result = copied(t)
  result.kind = "extremes"
  result.truth = self:column(t.truth, "truth", { "truth" })
  result.floor = self:column(t.floor, "floor", { "floor" })
  result.methods = self:each(t, "methods", function(entry, i)
    return self:column(entry, "method", { "methods", i }, "method " .. i)
  end)
  result.axes = self:each(t, "axes", function(entry, i) return self:axis(entry, i) end)
  if t.variants then
    result.variants = self:each(t, "variants", function(entry, i) return self:variant(entry, i) end)
    result.cases = self:each(t, "cases", function(entry, i)
      return self:column(entry, "case", { "cases", i }, "case " .. i)
    end)
    if type(t.cases) ~= "table" then self:add({ "variants" }, "variants want 'cases' in which they are measured") end
  end
  self:distinct(result.methods, "label", "methods")
  self:distinct(result.axes, "name", "axes")
  if type(t.factor) == "number" and not (t.factor > 1) then self:add({ "factor" }, "factor is not above 1") end
  local size = t.size
  if type(size) == "table" and not (#size == 2 and math.tointeger(size[1]) and math.tointeger(size[2])) then
    self:add({ "size" }, "size wants two whole numbers")
  end
  self.problems:raise()
  return result
end

return setmetatable(extremes, { __call = native.at_caller(function(place, _, t) return checked(place, t) end) })
