-- SPDX-License-Identifier: MIT
-- Demos: shots of scenes, columns of pipelines, one of them truth; `strobe demo` renders, measures and lays them out.
-- `demo { ... }` checks everything below it, all mistakes at once, and returns it as plain data.
local check  = require "strobe.check"
local fields = require "strobe.fields"
local native = require "strobe.native"

local demo = {}

-- Fields by table: their type, and whether they may be left out.
local text, number, bool, list, map = fields.text, fields.number, fields.bool, fields.list, fields.map
local settings, copied = fields.settings, fields.copied

demo.fields = {
  demo = {
    title = { text }, note = { text, optional = true }, size = { list, optional = true },
    seed = { number, optional = true }, shots = { list }, columns = { list },
    regions = { list, optional = true }, measures = { list, optional = true },
    difference_gain = { number, optional = true }, crop_size = { list, optional = true },
    background = { map, optional = true }, expectation = { map, optional = true },
  },
  -- Of a shot: fps, frame, exposure, camera: the scene's where left out. moves, spins: node = { dx, dy, dz } and
  -- node = { ax, ay, az, degrees }, per frame. truth: settings of the truth column here. crops: { x, y, width, height }
  -- at the demo's size, or "inner". picture_aa: sub-pixel samples of the pictures that are shown. stops, curve: how
  -- they are shown. full_shading: settings that make truth shade at each time, to be printed beside.
  shot = {
    title = { text }, note = { text, optional = true }, scene = { text }, camera = { text, optional = true },
    animation = { text, optional = true }, anchor = { text, optional = true }, fps = { number, optional = true },
    frame = { number, optional = true }, exposure = { number, optional = true }, moves = { map, optional = true },
    spins = { map, optional = true }, scene_set = { map, optional = true }, truth = { map, optional = true },
    crops = { list, optional = true }, picture_aa = { number, optional = true }, stops = { number, optional = true },
    curve = { text, optional = true }, full_shading = { map, optional = true }, attribution = { text, optional = true },
  },
  -- Of a column: role "method", "truth" or "floor" (truth at a method's own samples). own_anchor: measured against
  -- truth of that anchor as well. warm: settings of the run before the one that is timed. shown: on the sheet.
  column = {
    label = { text }, pipeline = { text }, set = { map, optional = true }, role = { text, optional = true },
    own_anchor = { text, optional = true }, warm = { map, optional = true }, shown = { bool, optional = true },
    box = { map, optional = true },
  },
  -- Of background: what a column knows of what is behind, for the contrast between it and what is in front.
  background = { column = { text }, color = { text }, valid = { text }, front = { text } },
  -- Of expectation: `column` in `region` has at most `share` of the RMSE of each of `baselines` and at most `floor`
  -- times that of the sampling floor, wherever the background varies by at least `contrast` of its difference.
  expectation = {
    column = { text }, baselines = { list }, region = { text }, share = { number }, floor = { number },
    contrast = { number },
  },
}

demo.regions  = { "whole", "inner", "hidden", "outer" }
demo.measures = { "rmse", "flip", "hdr_flip", "ms" }
local anchors = { "close", "centre", "open" }
local roles   = { "method", "truth", "floor" }
local curves  = { "clamp", "filmic" }

-- Where the mistakes of one demo are noted.
local Checker = fields.checker(demo.fields)

function Checker:numbers(value, count, path, what)
  if value == nil then return end
  local good = type(value) == "table" and #value == count
  for i = 1, good and count or 0 do good = good and type(value[i]) == "number" end
  if not good then self:add(path, "%s wants %d numbers", what, count) end
end

-- NODE=x,y,z as the command line would have it.
local function options(self, t, count, path, what)
  local result = {}
  for node, values in pairs(t or {}) do
    local before = #self.problems.list
    self:numbers(values, count, check.joined(path, node), ("%s of '%s'"):format(what, tostring(node)))
    if #self.problems.list == before then
      local parts = {}
      for i, value in ipairs(values) do parts[i] = ("%.9g"):format(value) end
      result[#result + 1] = ("%s=%s"):format(node, table.concat(parts, ","))
    end
  end
  return result
end

function Checker:column(t, path)
  t = self:fields(t, "column", path, "column " .. path[2])
  self:one_of(t.role, roles, check.joined(path, "role"), "the role of a column")
  self:one_of(t.own_anchor, anchors, check.joined(path, "own_anchor"), "own_anchor")
  local result = copied(t)
  result.set, result.warm, result.box = settings(t.set), settings(t.warm), settings(t.box)
  return result
end

function Checker:crops(t, path)
  for i, one in ipairs(t or {}) do
    if one ~= "inner" then self:numbers(one, 4, check.joined(path, i), "a crop that is not \"inner\"") end
  end
end

function Checker:shot(t, path)
  t = self:fields(t, "shot", path, "shot " .. path[2])
  self:one_of(t.anchor, anchors, check.joined(path, "anchor"), "the anchor")
  self:one_of(t.curve, curves, check.joined(path, "curve"), "the curve")
  if type(t.crops) == "table" then self:crops(t.crops, check.joined(path, "crops")) end
  local result = copied(t)
  if type(t.moves) == "table" then result.moves = options(self, t.moves, 3, check.joined(path, "moves"), "move") end
  if type(t.spins) == "table" then result.spins = options(self, t.spins, 4, check.joined(path, "spins"), "spin") end
  result.scene_set, result.truth = settings(t.scene_set), settings(t.truth)
  if t.full_shading then result.full_shading = settings(t.full_shading) end
  return result
end

function Checker:columns_as_a_whole(columns)
  local truths, labels = 0, {}
  for i, column in ipairs(columns) do
    truths = truths + (column.role == "truth" and 1 or 0)
    if column.label and check.contains(labels, column.label) then
      self:add({ "columns", i, "label" }, "another column is called '%s'", column.label)
    end
    labels[#labels + 1] = column.label
  end
  if truths ~= 1 then self:add({ "columns" }, "%d columns have the role \"truth\"; one must", truths) end
  return labels
end

function Checker:names_of(t, kind, labels, names)
  if t == nil then return end
  t = self:fields(t, kind, { kind })
  for _, name in ipairs(names) do
    local value = t[name]
    for _, label in ipairs(type(value) == "table" and value or { value }) do
      self:one_of(label, labels, { kind, name }, "the column")
    end
  end
end

local function checked(place, t)
  local self = Checker.at(place)
  if type(t) ~= "table" then check.fail(place, "demo wants a table: demo { ... }") end
  self:fields(t, "demo", {})
  local result = copied(t)
  result.kind = "demo"
  result.columns = self:each(t, "columns", function(entry, _, path) return self:column(entry, path) end)
  result.shots = self:each(t, "shots", function(entry, _, path) return self:shot(entry, path) end)
  local labels = self:columns_as_a_whole(result.columns)
  self:names_of(t.background, "background", labels, { "column", "front" })
  self:names_of(t.expectation, "expectation", labels, { "column", "baselines" })
  self:numbers(t.size, 2, { "size" }, "size")
  self:numbers(t.crop_size, 2, { "crop_size" }, "crop_size")
  for _, kind in ipairs { "regions", "measures" } do
    for i, name in ipairs(type(t[kind]) == "table" and t[kind] or {}) do
      self:one_of(name, demo[kind], { kind, i }, "one of the " .. kind)
    end
  end
  self.problems:raise()
  return result
end

return setmetatable(demo, { __call = native.at_caller(function(place, _, t) return checked(place, t) end) })
