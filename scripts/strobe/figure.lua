-- SPDX-License-Identifier: MIT
-- Checks the figures and films of a capture, and returns them as plain data. A figure is a grid of cells, each with a
-- picture. A film is a sequence of figures. A field of a cell may also be set in its figure, row or column, for all
-- cells there. If several of these set a field, the cell has priority, then the column, then the row, then the figure.
-- The marks and insets of all four are drawn. docs/figures.md describes each field.
local check  = require "strobe.check"
local fields = require "strobe.fields"
local native = require "strobe.native"
local shots  = require "strobe.shots"

local figure = {}

local text, number, bool, list, any = fields.text, fields.number, fields.bool, fields.list, fields.any
local copied, joined = fields.copied, check.joined

-- Returns a declaration of fields for strobe.fields: the fields in `more`, and the fields in `types`, { FIELD = type }, as
-- optional fields.
local function optional(types, more)
  local result = copied(more or {})
  for name, kind in pairs(types) do result[name] = { kind, optional = true } end
  return result
end

-- Fields with the marks that are drawn over a picture. Positions and lengths are in pixels of the captured picture, x right, y
-- down.
local marks = optional { arrows = list, circles = list, boxes = list, ranges = list, texts = list }

-- Fields of a cell: the choice of its picture, its display options, its texts, its insets and its marks.
local looks = optional({
  shot = text, arm = text, step = number, view = text, kind = text, low = number, high = number, stops = number,
  against = text, difference = text, gain = number, crop = list, zoom = number, shrink = number, key = bool,
  frame = text, caption = text, insets = list,
}, marks)

local whole = optional({
  title = text, note = text, columns = list, rows = list, cells = list, letters = bool, attribution = bool,
  gap = number, margin = number, border = number, text_size = number, width_mm = number, cell_width = number,
}, looks)

local own = { color = text, width = number, text = text }

figure.fields = {
  figure = copied(whole),
  film = optional({ fps = number, format = text }, whole),
  row = optional({ label = text, title = text, note = text }, looks),
  column = optional({ label = text }, looks),
  cell = optional({ row = any, column = any, empty = bool }, looks),
  inset = optional({ zoom = number, frame = text, at = text }, marks),
  arrow = optional({ to = list, on = text, from = list, by = list }, optional(own)),
  circle = optional({ at = list, on = text }, optional(own)),
  box = optional(own),
  range = optional({ anchor = text, along = text, samples = number, displacement = bool }, optional(own)),
  text = optional { color = text },
}
figure.fields.figure.name, figure.fields.film.name = { text }, { text }
figure.fields.inset.crop, figure.fields.box.area = { list }, { list }
figure.fields.circle.radius, figure.fields.range.at = { number }, { list }
figure.fields.text.at, figure.fields.text.text = { list }, { text }

figure.colors = {
  white = "#ffffff", black = "#000000", yellow = "#ffd21e", green = "#35d04f", red = "#ff4b3e", blue = "#3f7bff",
  cyan = "#26c6f2", magenta = "#f24fc0", orange = "#ff8c1a", grey = "#9a9aa2",
}
-- Measures that a caption may contain as {MEASURE}. `standard_error` and `displacement` are properties of the truth picture.
-- The other measures are errors of the cell's picture against the truth of the capture.
figure.measures = { "rmse", "mse", "relmse", "smape", "psnr", "ssim", "flip", "standard_error", "displacement" }
figure.kinds = { "auto", "colour", "depth", "normal", "velocity", "arrows", "id", "mask", "scalar" }
figure.differences = { "mean", "channels", "flip" }
figure.anchors = { "end", "centre", "start" }
figure.places = { "top left", "top right", "bottom left", "bottom right", "below" }
figure.formats = { "mp4", "mkv" }

local mark_kinds = { arrows = "arrow", circles = "circle", boxes = "box", ranges = "range", texts = "text" }
local mark_names = { "arrows", "boxes", "circles", "ranges", "texts" }
local added_up = { arrows = true, boxes = true, circles = true, ranges = true, texts = true, insets = true }

-- ---- checks

local Checker = fields.checker(figure.fields)
shots.extend(Checker, {})

function Checker:place_of(path) return native.key_place(self.place, table.unpack(path)) end

-- Checks that `value`, if it is a number, is from `least` to `most`. It must be a whole number unless `fraction` is true.
-- `what` names the value in messages.
function Checker:amount(value, least, most, path, what, fraction)
  if type(value) ~= "number" then return end
  local good = value >= least and value <= most and (fraction or math.tointeger(value))
  if good then return end
  local kind = fraction and "a number" or "a whole number"
  self:add(path, "%s is %s; it must be %s from %s to %s", what, fields.shown(value), kind, fields.shown(least),
           fields.shown(most))
end

-- Returns the colour `value`, which is "#rrggbb" or a name, as three numbers from 0 to 1; nil after a mistake.
function Checker:color(value, path)
  if type(value) ~= "string" then return nil end
  local r, g, b = (rawget(figure.colors, value) or value):match("^#(%x%x)(%x%x)(%x%x)$")
  if not r then
    local names = check.names(figure.colors)
    table.sort(names)
    self:add(path, "'%s' is not a colour; use \"#rrggbb\" or one of %s%s", value, table.concat(names, ", "),
             native.nearest(value, names))
    return nil
  end
  return { tonumber(r, 16) / 255, tonumber(g, 16) / 255, tonumber(b, 16) / 255 }
end

-- Checks an area of a picture: { x, y, width, height } or { REGION, width, height }, in whole pixels. The second form means the
-- rectangle of this size with the most pixels of REGION, an error region that truth computes.
function Checker:area(value, path, what)
  local before = #self.problems.list
  if type(value) == "table" and type(value[1]) == "string" then
    if #value ~= 3 or not math.tointeger(value[2]) or not math.tointeger(value[3]) or value[2] < 1 or value[3] < 1 then
      self:add(path, "%s must be { x, y, width, height } or { REGION, width, height } in whole pixels of the capture", what)
    elseif self.truth == false then
      self:add(path, "%s is placed by the region '%s' of truth, but the capture has no 'truth' arm", what, value[1])
    end
    return
  end
  self:numbers(value, 4, path, what)
  if type(value) ~= "table" or #self.problems.list > before then return end
  for i, least in ipairs { 0, 0, 1, 1 } do
    if not math.tointeger(value[i]) or value[i] < least then
      self:add(path, "%s must be { x, y, width, height } in whole pixels of the capture", what)
      return
    end
  end
end

-- Calls the function `one(entry, path)` to check each entry of the list t[name]. Returns the list of its results. Each result
-- gets the field `place`, the place of the entry in the script.
function Checker:entries(t, name, path, one)
  local result, given = {}, t[name]
  if type(given) ~= "table" then return result end
  local at = joined(path, name)
  if #given == 0 and next(given) ~= nil then self:add(at, "%s must be a list: { { ... }, ... }", name) end
  for i, entry in ipairs(given) do
    local here = joined(at, i)
    result[i] = one(entry, here)
    result[i].place = self:place_of(here)
  end
  return result
end

-- Checks the position of a mark: either a pixel { x, y } in t[key], or the name of a node of the scene in t.on. In the second
-- case the mark is at the screen position of the node.
function Checker:spot(t, key, path, what)
  self:numbers(t[key], 2, joined(path, key), ("'%s' of %s"):format(key, what))
  if (t[key] == nil) == (t.on == nil) then
    self:add(path, "%s must have either '%s' = { x, y } or 'on' = \"NODE\"", what, key)
  end
end

local marked = {}

function marked.arrow(self, t, path)
  self:spot(t, "to", path, "an arrow")
  self:numbers(t.from, 2, joined(path, "from"), "'from' of an arrow")
  self:numbers(t.by, 2, joined(path, "by"), "'by' of an arrow")
  if t.from ~= nil and t.by ~= nil then self:add(path, "an arrow cannot have both 'from' and 'by'") end
end

function marked.circle(self, t, path)
  self:spot(t, "at", path, "a circle")
  self:amount(t.radius, 0.1, 1e5, joined(path, "radius"), "the radius of a circle", true)
end

function marked.box(self, t, path) self:area(t.area, joined(path, "area"), "the area of a box") end

function marked.range(self, t, path)
  self:numbers(t.at, 2, joined(path, "at"), "'at' of a range")
  self:one_of(t.anchor, figure.anchors, joined(path, "anchor"), "the anchor of a range")
  self:amount(t.samples, 1, 1000, joined(path, "samples"), "'samples' of a range")
end

function marked.text(self, t, path) self:numbers(t.at, 2, joined(path, "at"), "'at' of a text") end

function Checker:mark(entry, kind, path)
  local article = kind == "arrow" and "an " or "a "
  local result = copied(self:fields(entry, kind, path, article .. kind))
  marked[kind](self, result, path)
  self:amount(result.width, 0.1, 100, joined(path, "width"), "the width of " .. article .. kind, true)
  result.color = self:color(result.color, joined(path, "color"))
  return result
end

-- Checks the marks in the table `t` (the lists `arrows`, `circles`, `boxes`, `ranges` and `texts`), and stores the checked
-- lists in `result`.
function Checker:marks(t, result, path)
  for _, name in ipairs(mark_names) do
    result[name] = self:entries(t, name, path, function(entry, at) return self:mark(entry, mark_kinds[name], at) end)
  end
end

function Checker:inset(entry, path)
  local result = copied(self:fields(entry, "inset", path, "an inset"))
  self:area(result.crop, joined(path, "crop"), "the crop of an inset")
  self:amount(result.zoom, 1, 64, joined(path, "zoom"), "the zoom of an inset")
  self:one_of(result.at, figure.places, joined(path, "at"), "the place of an inset")
  result.frame = self:color(result.frame, joined(path, "frame"))
  self:marks(result, result, path)
  return result
end

-- Parses a placeholder of a caption, the text between braces such as "rmse inner %.3f", "exposure" or "set.samples". Returns a
-- table with the measure, the setting, the option or the word to insert.
function Checker:inserted(inside, path)
  local rest, digits, style = inside:match("^(.-)%s+%%%.(%d)([fg])%s*$")
  local name, region = (rest or inside):match("^%s*([%w_.]+)%s*([%w_]*)%s*$")
  local part = { digits = tonumber(digits), style = style }
  if not name then
    self:add(path, "'{%s}' of a caption is not {MEASURE}, {MEASURE REGION}, {OPTION} or {set.PARAM}, each with or "
             .. "without %%.3f", inside)
  elseif name == "displacement" and region ~= "" then
    self:add(path, "the displacement of a caption has no region: it is measured over all moving surfaces")
  elseif check.contains(figure.measures, name) then
    part.measure, part.region = name, region ~= "" and region or "whole"
    if self.truth == false then
      self:add(path, "'{%s}' is measured against truth, but the capture has no 'truth' arm", inside)
    end
  elseif region ~= "" then
    self:add(path, "'%s' of a caption cannot have a region, because it is not a measure", name)
  elseif name:find("^set%.") or name:find("^scene%.") then
    part.setting = name
  elseif name == "shot" or name == "arm" or name == "step" then
    part.word = name
  elseif (self.options or {})[name] then
    part.option = name
  else
    local near = copied(figure.measures)
    for option in pairs(self.options or {}) do near[#near + 1] = option end
    self:add(path, "unknown '{%s}' in a caption: use one of the measures %s, an option of a shot, set.PARAM or scene.PARAM%s",
             name, table.concat(figure.measures, ", "), native.nearest(name, near))
  end
  return part
end

-- Returns a caption as a list of its parts, in order. A part is { text = ... } or a parsed placeholder.
function Checker:caption(value, path)
  if type(value) ~= "string" then return nil end
  local parts, at = {}, 1
  while at <= #value do
    local from, to = value:find("{[^{}]*}", at)
    local before = value:sub(at, (from or #value + 1) - 1)
    if before:find("[{}]") then self:add(path, "a caption has an unpaired brace: '%s'", value) end
    if before ~= "" then parts[#parts + 1] = { text = before } end
    if not from then break end
    parts[#parts + 1] = self:inserted(value:sub(from + 1, to - 1), path)
    at = to + 1
  end
  return parts
end

-- Checks the fields of a cell that the table `t` sets, and returns them. `t` is a figure, a row, a column or a cell.
function Checker:look(t, path)
  local result = {}
  for name in pairs(looks) do result[name] = t[name] end
  self:one_of(t.shot, self.shot_names, joined(path, "shot"), "the shot")
  self:one_of(t.arm, self.arm_names, joined(path, "arm"), "the arm")
  self:one_of(t.against, self.arm_names, joined(path, "against"), "the arm to compare with")
  self:one_of(t.kind, figure.kinds, joined(path, "kind"), "the kind of a view")
  self:one_of(t.difference, figure.differences, joined(path, "difference"), "the difference")
  self:amount(t.step, 0, 1e6, joined(path, "step"), "'step'")
  self:amount(t.zoom, 1, 64, joined(path, "zoom"), "'zoom'")
  self:amount(t.shrink, 1, 64, joined(path, "shrink"), "'shrink'")
  self:amount(t.gain, 1e-6, 1e6, joined(path, "gain"), "'gain'", true)
  self:area(t.crop, joined(path, "crop"), "the crop")
  result.frame = self:color(t.frame, joined(path, "frame"))
  result.caption = self:caption(t.caption, joined(path, "caption"))
  result.insets = self:entries(t, "insets", path, function(entry, at) return self:inset(entry, at) end)
  self:marks(t, result, path)
  return result
end

-- Checks the field `name` of the figure `t`, "rows" or "columns". Returns two lists with one entry per row or column: its label
-- and texts, and the fields that it sets in its cells. If `t` lacks the field, the figure has a single row or column without a
-- label.
function Checker:lines(t, name, path)
  local looked = {}
  local labels = self:entries(t, name, path, function(entry, at)
    local kind = name:sub(1, -2)
    local line = self:fields(entry, kind, at, ("%s %d"):format(kind, at[#at]))
    looked[#looked + 1] = self:look(line, at)
    return { label = line.label or (name == "columns" and line.arm) or nil, title = line.title,
             note = self:caption(line.note, joined(at, "note")) }
  end)
  if #labels == 0 then return { {} }, { {} } end
  return labels, looked
end

-- Returns the number of a row or column, from 1. `labels`: the rows or the columns of the figure. `value`: the number or
-- the label of the row or column; may be nil if `labels` has a single entry.
function Checker:line_number(value, labels, path, what)
  local names = {}
  for i, line in ipairs(labels) do
    if value == i or (line.label and line.label == value) then return i end
    names[i] = line.label
  end
  if value == nil and #labels == 1 then return 1 end
  local near = type(value) == "string" and native.nearest(value, names) or ""
  self:add(path, "%s of a cell is %s; it must be a number from 1 to %d or a label%s", what, check.quoted(value), #labels, near)
end

-- Merges the fields of one cell. `parts`: the fields set in the figure, the row, the column and the cell, in this order. A
-- later part overrides an earlier part, but the marks and insets of all parts are kept.
local function united(parts)
  local result = {}
  for _, part in ipairs(parts) do
    for name, value in pairs(part) do
      if added_up[name] then
        local all = table.move(value, 1, #value, #(result[name] or {}) + 1, result[name] or {})
        result[name] = all
      else
        result[name] = value
      end
    end
  end
  return result
end

-- Completes and checks a cell after its fields have been merged. If the capture has only one shot or arm, the cell need not
-- name it.
function Checker:finish_cell(cell, path)
  local where = ("the cell in row %d, column %d"):format(cell.row, cell.column)
  cell.shot = cell.shot or (#self.shot_names == 1 and self.shot_names[1]) or nil
  cell.arm = cell.arm or (#self.arm_names == 1 and self.arm_names[1]) or nil
  for _, name in ipairs { "shot", "arm" } do
    if cell[name] == nil then self:add(path, "%s has no %s", where, name) end
  end
  if cell.against == nil and (cell.difference ~= nil or cell.gain ~= nil) then
    self:add(path, "%s has a %s, but no 'against', the arm to compare with", where, cell.gain and "gain" or "difference")
  end
  if cell.against ~= nil and cell.kind ~= nil then
    self:add(path, "%s shows a difference, so it cannot have a 'kind'", where)
  end
  if cell.difference == "flip" and cell.gain ~= nil then
    self:add(path, "%s: a difference by FLIP has a fixed scale from 0 to 1, so it cannot have a gain", where)
  end
  if (cell.zoom or 1) > 1 and (cell.shrink or 1) > 1 then
    self:add(path, "%s has both a zoom and a shrink", where)
  end
  if self.cell_width and (cell.zoom or cell.shrink) then
    self:add(path, "%s has a %s, but its size is set by the figure's cell_width", where, cell.zoom and "zoom" or "shrink")
  end
end

-- Returns all cells of the figure `t` that are not empty, row by row. The fields of a cell are merged from the figure, its row,
-- its column and its entry in the field `cells`.
function Checker:cells(t, result, path, rows, columns)
  local of_figure, given = self:look(t, path), {}
  self:entries(t, "cells", path, function(entry, at)
    local what = "cell " .. at[#at]
    local own_fields = self:fields(entry, "cell", at, what)
    local r = self:line_number(own_fields.row, result.rows, joined(at, "row"), "'row'")
    local c = self:line_number(own_fields.column, result.columns, joined(at, "column"), "'column'")
    local look = self:look(own_fields, at)
    look.empty, look.place, look.path = own_fields.empty, self:place_of(at), at
    if r and c then
      local key = r * 100000 + c
      if given[key] then self:add(at, "another entry of cells has row %d and column %d", r, c) end
      given[key] = look
    end
    return {}
  end)
  local cells = {}
  for r = 1, #result.rows do
    for c = 1, #result.columns do
      local particular = given[r * 100000 + c] or { place = result.place }
      local at = particular.path or path
      local cell = united { of_figure, rows[r], columns[c], particular }
      cell.row, cell.column, cell.path = r, c, nil
      if not cell.empty then
        self:finish_cell(cell, at)
        cells[#cells + 1] = cell
      end
    end
  end
  if #cells == 0 then self:add(path, "every cell is empty") end
  return cells
end

function Checker:whole(t, kind, path)
  t = self:fields(t, kind, path, kind .. " " .. tostring(path[#path]))
  if type(t.name) == "string" and not t.name:find("^[%w_][%w_.-]*$") then
    self:add(joined(path, "name"), "'%s' is not a file name; use letters, digits, _, - and .", t.name)
  end
  local result = { place = self:place_of(path) }
  for name in pairs(self.kept) do result[name] = t[name] end
  for name, most in pairs { gap = 1000, margin = 1000, border = 100 } do
    self:amount(t[name], 0, most, joined(path, name), ("'%s'"):format(name))
  end
  self:amount(t.text_size, 4, 200, joined(path, "text_size"), "'text_size'", true)
  self:amount(t.width_mm, 10, 2000, joined(path, "width_mm"), "'width_mm'", true)
  self:amount(t.cell_width, 16, 8192, joined(path, "cell_width"), "'cell_width'")
  self.cell_width = t.cell_width
  self:amount(t.fps, 0.1, 240, joined(path, "fps"), "'fps'", true)
  self:one_of(t.format, figure.formats, joined(path, "format"), "the format of a film")
  local rows, columns
  result.rows, rows = self:lines(t, "rows", path)
  result.columns, columns = self:lines(t, "columns", path)
  result.cells = self:cells(t, result, path, rows, columns)
  return result
end

local kept = {}
for _, name in ipairs { "name", "title", "note", "letters", "attribution", "gap", "margin", "border", "text_size",
                        "width_mm", "cell_width", "fps", "format" } do
  kept[name] = true
end

local function checked(self, entry, kind, path, names)
  local own_checker = setmetatable({ place = self.place, problems = self.problems, options = self.options, kept = kept,
    shot_names = names.shots, arm_names = names.arms, truth = names.truth }, Checker)
  return own_checker:whole(entry, kind, path)
end

-- Checks the figure or film `entry`, and returns it as plain data. `self`: the checker of the capture. `path`: keys that lead
-- from the capture to `entry`. `names.shots`, `names.arms`: names of the capture's shots and arms. `names.truth`: name of its
-- truth arm, or false.
function figure.checked(self, entry, path, names) return checked(self, entry, "figure", path, names) end
function figure.checked_film(self, entry, path, names) return checked(self, entry, "film", path, names) end

check.closed(figure, "figure")

return figure
