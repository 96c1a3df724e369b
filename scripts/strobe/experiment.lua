-- SPDX-License-Identifier: MIT
-- The function `experiment { ... }`. It declares an experiment: arms (pipelines with settings) render shots (scenes with
-- options), once for each combination of the values of its axes (the varied quantities). `strobe sweep` measures the pictures
-- against truth, and expectations test the results. This file checks the fields, reports all mistakes of an experiment at once,
-- and returns the experiment as plain data. docs/writing-experiments.md lists the fields.
local check  = require "strobe.check"
local fields = require "strobe.fields"
local judge  = require "strobe.judge"
local native = require "strobe.native"
local shots  = require "strobe.shots"
local vary   = require "strobe.vary"

local experiment = {}

local text, number, bool, list, map = fields.text, fields.number, fields.bool, fields.list, fields.map
local func, shown, copied = fields.func, fields.shown, fields.copied

-- Fields of an experiment and of the tables inside it, by kind of table, with the types of their values. Optional fields may be
-- left out. A shot may also have any option of the command line, under the option's name (`exposure`, `camera`).
experiment.fields = {
  experiment = {
    title = { text }, question = { text, optional = true }, note = { text, optional = true },
    size = { list, optional = true }, size_params = { list, optional = true }, seed = { number, optional = true },
    shots = { list }, arms = { list }, truth = { map }, vary = { list, optional = true },
    skip = { func, optional = true }, regions = { list, optional = true }, measures = { list, optional = true },
    rounds = { number, optional = true }, most_rounds = { number, optional = true },
    within = { number, optional = true }, base = { text, optional = true },
    background = { map, optional = true }, expect = { list, optional = true },
    layout = { map, optional = true },
  },
  -- Fields of a shot:
  -- title        text that is displayed instead of the name
  -- note         text for the report
  -- attribution  author of the scene; default: read from the file of the scene
  -- truth        settings of truth for this shot
  -- crops        areas that the report magnifies: { x, y, width, height } in pixels of the experiment's size, or
  --              "inner", the place with the most pixels of the error region inner
  -- picture_aa   number of sub-pixel samples of the displayed pictures; the measured pictures have one sample per pixel
  -- stops        brightness of the displayed pictures: factor 2^stops
  -- curve        tone curve of the displayed pictures
  -- frames       { from, to, step }: the shot is a sequence of frames, and a measure is the mean over the frames
  shot = {
    name = { text }, title = { text, optional = true }, note = { text, optional = true },
    attribution = { text, optional = true }, truth = { map, optional = true }, crops = { list, optional = true },
    picture_aa = { number, optional = true }, stops = { number, optional = true }, curve = { text, optional = true },
    frames = { list, optional = true },
  },
  -- Fields of an arm, which is a pipeline with settings:
  -- role       "method", or "floor" (truth with as many samples as a method)
  -- lacks      names of axes, or of single parameters of an axis, that do not apply to this arm. The arm is drawn without
  --            setting the parameters of these axes, or these parameters
  -- box        settings that make the pipeline itself take several samples per pixel. They are added for the displayed
  --            pictures of shots with `picture_aa`, and replace the sub-pixel samples of `picture_aa`
  -- shown      false: the arm is in the tables of the report, but its pictures are not shown
  -- timed      true: frame times are measured; default: true for methods, false for truth
  -- published  published frame rate of this arm: fps in the shot `shot`, measured by the authors `by`
  arm = {
    name = { text }, pipeline = { text }, set = { map, optional = true }, role = { text, optional = true },
    lacks = { list, optional = true }, box = { map, optional = true },
    shown = { bool, optional = true }, timed = { bool, optional = true }, published = { map, optional = true },
  },
  published = { fps = { number }, shot = { text }, by = { text } },
  -- The truth of the experiment: the pipeline that draws the reference of all errors, with its settings `set`. `full`: settings
  -- of a second truth, which is the reference of the measure rmse_full.
  truth = {
    name = { text, optional = true }, pipeline = { text }, set = { map, optional = true },
    full = { map, optional = true },
  },
  -- Fields of an axis, which is one varied quantity with its values:
  -- at            function that returns the settings for a value; default: the value sets the parameter or option that has the
  --               name of the axis
  -- shots         names of the shots that vary along the axis; default: all
  -- title, unit   texts for charts
  -- scale         scale of charts, one of experiment.scales
  -- benign        value where the varied quantity causes no error; the pictures at the other values are compared with the
  --               picture at this value
  -- region        error region of the errors that the charts show
  -- same_picture  true: the exact picture is the same for all values. The report then states how much truth changes
  --               along the axis; such a change is an error of truth
  -- fixed         text for the report: the quantities that do not vary
  -- note          text for the report
  -- reading       text for the report; {ARM @ VALUE} in the text is replaced by the error of the arm ARM at the value VALUE
  -- against       measure that `strobe bench slopes` plots times against; default: the values of the axis
  -- costs         list of expectations about the growth of the times of parts of a frame along the axis, which
  --               `strobe bench slopes` tests
  axis = {
    name = { text }, values = { list }, at = { func, optional = true }, shots = { list, optional = true },
    title = { text, optional = true }, unit = { text, optional = true }, scale = { text, optional = true },
    benign = { fields.any, optional = true }, region = { text, optional = true },
    same_picture = { bool, optional = true },
    fixed = { text, optional = true }, note = { text, optional = true }, reading = { text, optional = true },
    against = { text, optional = true }, costs = { list, optional = true },
  },
  -- Expected growth of the time of one part of the frame along an axis. part: "frame", the name of a node, or "passes" (each
  -- pass that no other entry names). grows: one of experiment.growths. why: the reason. arm: the arm that the entry applies to;
  -- default: every arm.
  cost = { part = { text }, grows = { text }, arm = { text, optional = true }, why = { text, optional = true } },
  -- The arms that the measures background_* compare. arm: the arm that computes the background; `color` and `valid` are the
  -- names of its outputs with the colour and with the mask of the known pixels. front: the arm that shows the foreground.
  background = { arm = { text }, color = { text }, valid = { text }, front = { text } },
  layout = {
    pictures = { map, optional = true }, curves = { map, optional = true }, front = { map, optional = true },
    table = { map, optional = true },
  },
  -- The pictures of each shot. crop_size: { width, height } of crops without a size of their own, in pixels of the experiment's
  -- size. difference_gain: factor that brightens the pictures of differences from truth.
  pictures = { crop_size = { list, optional = true }, difference_gain = { number, optional = true } },
  -- The errors along each axis, as curves. The floor is the error of the arm with the role "floor". For each arm, the
  -- report also states the range of values around the benign value where the error of the arm is at most `factor` times the
  -- floor.
  curves = { factor = { number, optional = true } },
  -- The Pareto front of each shot, as a chart. x, y: names of the measures on the axes of the chart. region: error region of
  -- the measure y, and of x if x is measured by region. together: true for one chart with the points of all shots, without the
  -- front but with the line y = x, to compare two measures of one quantity.
  front = {
    x = { text, optional = true }, y = { text, optional = true }, region = { text, optional = true },
    title = { text, optional = true }, note = { text, optional = true }, together = { bool, optional = true },
  },
  -- Fields of the layout `table`, tables with one row per arm and value of an axis:
  -- axes   names of axes; each gets a table. Without this field there is one table, with one row per point
  -- cells  measures to show for every shot
  -- once   measures to show for the first shot only
  -- share  true: errors are divided by the contrast of truth (the standard deviation of its colours)
  -- title  title of the section
  table = {
    axes = { list, optional = true }, cells = { list, optional = true }, once = { list, optional = true },
    share = { bool, optional = true }, title = { text, optional = true }, note = { text, optional = true },
  },
}

-- Scales of an axis in charts. "log": logarithmic, with a separate place for 0. "even": the values at equal distances, in their
-- order.
experiment.scales = { "log", "linear", "even" }
experiment.roles = { "method", "floor" }
-- Measures that `against` of an axis may name. `strobe bench slopes` can plot times against these measures, because
-- their values depend on the picture alone and not on the speed of the machine.
experiment.counted = { "masked", "displacement" }
-- Kinds of growth of a time along an axis, for the field `grows` of `costs`.
experiment.growths = { "constant", "linear", "logarithmic" }

-- Constructors of axes (list, grid, zip, each, ablation, random, sobol) and of lists of values (linear, log), all from
-- strobe.vary.
for _, kind in ipairs { "list", "grid", "zip", "each", "ablation", "random", "sobol", "linear", "log" } do
  experiment[kind] = vary[kind]
end

-- ---- checks

local Checker = fields.checker(experiment.fields)
shots.extend(Checker, experiment.fields.shot)

function Checker:arm(t, path)
  local result = copied(self:fields(t, "arm", path, "arm " .. path[2]))
  result.place = self:place_of(path)
  self:one_of(result.role, experiment.roles, check.joined(path, "role"), "the role of an arm")
  for _, name in ipairs { "set", "box" } do result[name] = self:settings(result[name], check.joined(path, name)) end
  if result.published ~= nil then
    local at = check.joined(path, "published")
    local published = self:fields(result.published, "published", at, "'published' of arm " .. path[2])
    self:one_of(published.shot, self.shot_names, check.joined(at, "shot"), "the shot")
  end
  return result
end

function Checker:truth(t)
  local result = copied(self:fields(t, "truth", { "truth" }))
  result.place = self:place_of { "truth" }
  result.set = self:settings(result.set, { "truth", "set" })
  if result.full then result.full = self:settings(result.full, { "truth", "full" }) end
  result.name = result.name or "ground truth"
  return result
end

-- Returns the settings for one value of an axis. `axis`: the checker of the axis. `t`: the fields of the axis. `value`: the
-- value. `at`: the index of the value in `t.values`, for the places of mistakes.
local function value_of(axis, t, value, at)
  local result = { value = value, label = shown(value), truth = {} }
  local sets = { [t.name or ""] = value }
  if t.at then
    local good, returned = pcall(t.at, value)
    if not good or type(returned) ~= "table" then
      local problem = type(returned) == "table" and returned.message or tostring(returned)
      if good then problem = "it returns a " .. type(returned) end
      axis:add({ "at" }, "at(%s) of axis '%s' fails: %s", shown(value), tostring(t.name), problem)
      return result
    end
    sets = copied(returned)
    result.truth, sets.truth = axis:settings(sets.truth, { "at" }), nil
  end
  local sorted = axis:sorted(sets, { t.at and "at" or "values" }, ("axis '%s'"):format(tostring(t.name)))
  result.options, result.scene, result.set = sorted.options, sorted.scene, sorted.others
  for _, entry in ipairs(sorted.others) do
    local kind = type(entry.value)
    if kind ~= "string" and kind ~= "number" and kind ~= "boolean" then
      axis:add({ t.at and "at" or "values", at },
               "'%s' is a %s, but the value of a parameter must be a number, a text or a boolean", entry.name, kind)
    end
  end
  return result
end

local function is_finite(value) return type(value) == "number" and value == value and math.abs(value) ~= math.huge end

-- Checks the fields `costs` and `against` of the axis `t`: the expected growth of times, and the measure that times are plotted
-- against. Without `against`, times are plotted against the values of the axis, so the values must be numbers.
function Checker:costs(t)
  if t.costs == nil and t.against == nil then return end
  self:one_of(t.against, experiment.counted, { "against" }, "'against' of an axis")
  for i, entry in ipairs(type(t.costs) == "table" and t.costs or {}) do
    local path = { "costs", i }
    local cost = self:fields(entry, "cost", path, ("entry %d of costs"):format(i))
    self:one_of(cost.grows, experiment.growths, check.joined(path, "grows"), "'grows' of a cost")
    self:one_of(cost.arm, self.arm_names, check.joined(path, "arm"), "the arm")
  end
  for i, value in ipairs(t.against == nil and type(t.values) == "table" and t.values or {}) do
    if not is_finite(value) then
      self:add({ "values", i }, "times cannot grow with %s, which is not a number", check.quoted(value))
    end
  end
end

-- Checks an axis and returns it as plain data. `made`: an axis as strobe.vary makes it. Mistakes get the place `made.place`,
-- the line of the experiment that declares the axis.
function Checker:axis(made)
  local axis = setmetatable(copied(self), Checker)
  axis.place = made.place
  local t = axis:fields(made.fields, "axis", {}, ("axis '%s'"):format(tostring(made.fields.name)))
  local result = copied(t)
  result.values, result.at = {}, nil
  axis:one_of(t.scale, experiment.scales, { "scale" }, "the scale of an axis")
  axis:one_of(t.region, self.known.regions, { "region" }, "the region of an axis")
  axis:costs(t)
  for i, name in ipairs(type(t.shots) == "table" and t.shots or {}) do
    axis:one_of(name, self.shot_names, { "shots", i }, "the shot")
  end
  if type(t.values) ~= "table" then return result end
  if #t.values == 0 then axis:add({ "values" }, "axis '%s' has no values", tostring(t.name)) end
  local before
  for i, value in ipairs(t.values) do
    if type(value) == "number" and not is_finite(value) then
      axis:add({ "values", i }, "value %d is not a finite number", i)
    elseif t.scale and t.scale ~= "even" and not is_finite(value) then
      axis:add({ "values", i }, "%s cannot be placed on a %s scale", check.quoted(value), t.scale)
    elseif t.scale and is_finite(value) then
      if before and value <= before then
        axis:add({ "values", i }, "the values must increase, but %s follows %s", shown(value), shown(before))
      end
      if t.scale == "log" and value < 0 then
        axis:add({ "values", i }, "%s is negative and cannot be placed on a logarithmic scale", shown(value))
      end
      before = value
    end
    result.values[i] = value_of(axis, t, value, i)
  end
  if t.benign ~= nil then
    for i, value in ipairs(t.values) do if value == t.benign then result.benign_index = i end end
    if not result.benign_index then
      axis:add({ "benign" }, "benign is %s, which is not one of the values", shown(t.benign))
    end
  end
  result.benign = nil
  return result
end

-- Returns all axes, and all combinations of their values. `given`: the field `vary`. A combination is a list with an entry {
-- axis = index of the axis, value = index of the value } for each axis.
function Checker:varied(given)
  local axes, names, values, lists = {}, {}, {}, {}
  for i, part in ipairs(given) do
    if not vary.is_varied(part) then
      self:add({ "vary", i }, "entry %d of vary is not one of list, grid, zip, each, ablation, random, sobol", i)
      return {}, { {} }
    end
    for _, made in ipairs(part.axes) do
      local axis = self:axis(made)
      if axis.name ~= nil and check.contains(names, axis.name) then
        self.problems:add(made.place, "another axis is called '%s'", tostring(axis.name))
      end
      axes[#axes + 1], names[#names + 1] = axis, axis.name
      values[made] = {}
      for n in ipairs(axis.values) do values[made][n] = { { axis = #axes, value = n } } end
    end
    lists[i] = part.combine(values)
  end
  return axes, vary.multiplied(lists)
end

-- ---- points

local function allowed(axes, combination, shot)
  for _, at in ipairs(combination) do
    local only = axes[at.axis].shots
    if only and not check.contains(only, shot.name) then return false end
  end
  return true
end

-- Returns a function that makes the argument `point` of the experiment's function `skip`. The point has the name of its shot,
-- the name of its arm, and the value of each axis under the axis's name.
local function points_of(axes)
  local names = {}
  for i, axis in ipairs(axes) do names[i] = axis.name end
  local point = check.record("a point", names)
  return function(combination, shot, arm)
    local result = { shot = shot.name, arm = arm.name }
    for _, at in ipairs(combination) do result[axes[at.axis].name] = axes[at.axis].values[at.value].value end
    return point(result)
  end
end

-- Returns the groups of points. The points of a group have one shot and one combination of axis values, and share one picture
-- of truth. A group has the indices of the arms that render it: all arms, unless the function `skip` leaves an arm out of this
-- group. Groups are sorted by shot, then by combination, and the arms of a group by index.
function Checker:groups(result, skip, combinations)
  local groups, point_of = {}, points_of(result.axes)
  for s, shot in ipairs(result.shots) do
    for _, combination in ipairs(combinations) do
      local group = { shot = s, at = combination, arms = {} }
      for a, arm in ipairs(allowed(result.axes, combination, shot) and result.arms or {}) do
        local good, skipped = true, false
        if skip then good, skipped = pcall(skip, point_of(combination, shot, arm)) end
        if not good then
          local problem = type(skipped) == "table" and skipped.problems and skipped.problems[1].message or tostring(skipped)
          self:add({ "skip" }, "skip fails: %s", problem)
          return groups
        end
        if not skipped then group.arms[#group.arms + 1] = a end
      end
      if #group.arms > 0 then groups[#groups + 1] = group end
    end
  end
  if #groups == 0 then
    self:add({ "vary" }, "the experiment has no points: it has no arms, or the function skip leaves out all points")
  end
  return groups
end

-- ---- other fields

-- Returns the names that the field `lacks` of an arm may contain: names of axes, and names of parameters that an axis sets.
local function lackable(axes)
  local names = {}
  for _, axis in ipairs(axes) do
    if not check.contains(names, axis.name) then names[#names + 1] = axis.name end
    for _, value in ipairs(axis.values) do
      for _, set in ipairs(value.set or {}) do
        if not check.contains(names, set.name) then names[#names + 1] = set.name end
      end
    end
  end
  return names
end

function Checker:lacks(arms, axes)
  local known = lackable(axes)
  for i, arm in ipairs(arms) do
    for k, name in ipairs(type(arm.lacks) == "table" and arm.lacks or {}) do
      if not check.contains(known, name) then
        local near = type(name) == "string" and native.nearest(name, known) or ""
        if near == "" and #known > 0 then near = "; it may name " .. table.concat(known, ", ") end
        self:add({ "arms", i, "lacks", k },
                 "'lacks' of arm '%s' names %s, which is neither an axis nor a parameter that an axis sets%s",
                 tostring(arm.name), check.quoted(name), near)
      end
    end
  end
end

-- Returns placeholder results of the experiment, with the value 1 for each measure at each point. Expectations are tried on
-- them to find mistakes before anything is rendered.
local function placeholders(result, given)
  local values = {}
  -- All measures that exist: a layout may add measures that the experiment does not name.
  for _, name in ipairs(given.measures) do values[name] = { all = 1 } end
  local arms = copied(result.arms)
  arms[#arms + 1] = { name = result.truth.name, role = "truth" }
  local groups = {}
  for g, group in ipairs(result.groups) do
    local made = { shot = result.shots[group.shot].name, at = {}, points = {} }
    for _, at in ipairs(group.at) do
      made.at[result.axes[at.axis].name] = result.axes[at.axis].values[at.value].value
    end
    local numbers = table.move(group.arms, 1, #group.arms, 2, { #arms })
    for k, a in ipairs(numbers) do
      made.points[k] = { role = arms[a].role or "method", arm = arms[a].name, values = values }
    end
    groups[g] = made
  end
  local axes = {}
  for i, axis in ipairs(result.axes) do
    axes[i] = { name = axis.name, values = {} }
    for k, value in ipairs(axis.values) do axes[i].values[k] = value.value end
  end
  local regions = result.regions or given.default_regions
  return { arms = arms, shots = result.shots, regions = regions, axes = axes, groups = groups }
end

function Checker:expectations(t, shot_names, axes)
  local functions, names = {}, {}
  for i, axis in ipairs(axes) do names[i] = axis.name end
  for i, entry in ipairs(type(t) == "table" and t or {}) do
    local path = { "expect", i }
    if type(entry) ~= "table" or type(entry[1]) ~= "string" or type(entry[2]) ~= "function" then
      self:add(path, "expectation %d is not { \"what is expected\", function(r) ... end }", i)
    else
      check.keys(self.problems, entry, { 1, 2, "shot", "axis", "known" }, self.place, "expectation " .. i, path)
      self:one_of(entry.shot, shot_names, check.joined(path, "shot"), "the shot of an expectation")
      self:one_of(entry.axis, names, check.joined(path, "axis"), "the axis of an expectation")
      functions[i] = entry
    end
  end
  return functions
end

-- Checks the layout `t` with `curves`: at least one axis must have the fields `region`, `scale` and `benign`, which a curve
-- needs.
function Checker:curves(t, axes)
  if t.curves == nil then return end
  local lacking = {}
  for i, axis in ipairs(axes) do
    local without = {}
    for _, key in ipairs { "region", "scale", "benign" } do
      local given = key == "benign" and axis.benign_index or axis[key]
      if given == nil then without[#without + 1] = key end
    end
    if #without == 0 then return end
    lacking[i] = ("; axis '%s' has no %s"):format(tostring(axis.name), table.concat(without, ", "))
  end
  self:add({ "layout", "curves" }, "there are no curves to draw: curves need an axis with `region`, `scale` and `benign`%s",
           table.concat(lacking))
end

function Checker:layout(t, axes, regions)
  if t == nil then return nil end
  self:fields(t, "layout", { "layout" })
  for _, kind in ipairs { "pictures", "curves", "front", "table" } do
    if t[kind] ~= nil then self:fields(t[kind], kind, { "layout", kind }, "the layout " .. kind) end
  end
  self:curves(t, axes)
  if type(t.pictures) == "table" then
    self:numbers(t.pictures.crop_size, 2, { "layout", "pictures", "crop_size" }, "crop_size")
  end
  local names = {}
  for i, axis in ipairs(axes) do names[i] = axis.name end
  local front = type(t.front) == "table" and t.front or {}
  for _, key in ipairs { "x", "y" } do
    self:one_of(front[key], self.known.measures, { "layout", "front", key }, key .. " of the front")
  end
  self:one_of(front.region, type(regions) == "table" and regions or self.known.regions,
              { "layout", "front", "region" }, "the region of the front")
  local laid = type(t.table) == "table" and t.table or {}
  for i, name in ipairs(type(laid.axes) == "table" and laid.axes or {}) do
    self:one_of(name, names, { "layout", "table", "axes" }, ("axis %d of the table"):format(i))
  end
  for _, kind in ipairs { "cells", "once" } do
    for _, name in ipairs(type(laid[kind]) == "table" and laid[kind] or {}) do
      self:one_of(name, self.known.measures, { "layout", "table", kind }, "one of the measures")
    end
  end
  return t
end

function Checker:names_of(t, kind, known)
  for i, name in ipairs(type(t[kind]) == "table" and t[kind] or {}) do
    self:one_of(name, known, { kind, i }, "one of the " .. kind)
  end
end

function Checker:whole(t)
  self:fields(t, "experiment", {})
  local result = copied(t)
  result.shots = self:each(t, "shots", function(entry, _, path) return self:shot(entry, path) end)
  self.shot_names = self:distinct(result.shots, "name", "shots")
  result.arms = self:each(t, "arms", function(entry, _, path) return self:arm(entry, path) end)
  result.truth = self:truth(t.truth)
  local arm_names, shot_names = self:distinct(result.arms, "name", "arms"), self.shot_names
  if check.contains(arm_names, result.truth.name) then
    self:add({ "truth", "name" }, "truth and an arm are both called '%s'", result.truth.name)
  end
  self:numbers(t.size, 2, { "size" }, "size")
  self:one_of(t.base, arm_names, { "base" }, "the base")
  self:names_of(t, "regions", self.known.regions)
  self:names_of(t, "measures", self.known.measures)
  self.arm_names = arm_names
  local combinations
  result.axes, combinations = self:varied(type(t.vary) == "table" and t.vary or {})
  self:lacks(result.arms, result.axes)
  if t.background ~= nil then
    local background = self:fields(t.background, "background", { "background" })
    for _, name in ipairs { "arm", "front" } do
      self:one_of(background[name], arm_names, { "background", name }, "the arm")
    end
  end
  result.layout = self:layout(t.layout, result.axes, t.regions)
  local expectations = self:expectations(t.expect, shot_names, result.axes)
  self.problems:raise()
  result.groups = self:groups(result, t.skip, combinations)
  self.problems:raise()
  result.vary, result.skip, result.expect, result.kind = nil, nil, nil, "experiment"
  return result, expectations
end

-- ---- entry points

-- Checks the experiment with the fields `t`, declared at `place`. Returns it as plain data, or, if `given` has results, the
-- outcomes of the expectations on these results. `given.options`, `given.regions`, `given.measures`: the options, error regions
-- and measures that exist. `given.results`: results of the experiment.
function experiment.finished(t, place, given)
  local self = Checker.at(place)
  self.known, self.options = given, shots.by_name(given.options)
  local plain, expectations = self:whole(t)
  if given.results then return judge.outcomes(expectations, given.results, given) end
  judge.rehearse(self.problems, expectations, placeholders(plain, given), given)
  self.problems:raise()
  plain.expectations = #expectations
  return plain
end

local Made = { kind = "experiment" }

-- Checks `result`, which the file of an experiment returned, and returns it as plain data. If `given` has no measures, the
-- command does not measure; only the kind of the file is returned, so that the command can refuse the file.
function Made.finished(result, given)
  if not given.measures then return { kind = "experiment" } end
  return experiment.finished(result.fields, result.place, given)
end

return setmetatable(experiment, { __call = native.at_caller(function(place, _, t)
  if type(t) ~= "table" then check.fail(place, "experiment takes a table: experiment { ... }") end
  return setmetatable({ fields = t, place = place }, Made)
end) })
