-- SPDX-License-Identifier: MIT
-- Checks of shots and settings in experiments and captures. The checked values are returned as plain data.
local check  = require "strobe.check"
local fields = require "strobe.fields"
local native = require "strobe.native"

local shots = {}

local shown, copied = fields.shown, fields.copied

-- Tone curves for displayed pictures, which have low dynamic range.
shots.tones = { "clamp", "filmic" }

local Methods = {}

function Methods:place_of(path) return native.key_place(self.place, table.unpack(path)) end

-- Returns the table of settings `t`, { NAME = value }, as a list of { name, value, place }, sorted by name.
function Methods:settings(t, path)
  local result, names = {}, type(t) == "table" and check.names(t) or {}
  table.sort(names)
  for i, name in ipairs(names) do
    local kind = type(t[name])
    if kind ~= "string" and kind ~= "number" and kind ~= "boolean" then
      self:add(check.joined(path, name), "'%s' is a %s, but the value of a parameter must be a number, a text or a boolean",
               name, kind)
    end
    result[i] = { name = name, value = t[name], place = self:place_of(check.joined(path, name)) }
  end
  return result
end

function Methods:numbers(value, count, path, what)
  if value == nil then return end
  local good = type(value) == "table" and #value == count
  for i = 1, good and count or 0 do good = good and type(value[i]) == "number" end
  if not good then self:add(path, "%s takes %d numbers", what, count) end
end

-- Returns the motions of nodes in the table `t`, such as { NODE = { x, y, z } }, as a list of arguments of the command line,
-- "NODE=x,y,z". The list is sorted by node. `count`: the number of numbers of each motion.
function Methods:motions(t, count, path, what)
  local result, names = {}, type(t) == "table" and check.names(t) or {}
  table.sort(names)
  for _, node in ipairs(names) do
    local before, parts = #self.problems.list, {}
    self:numbers(t[node], count, check.joined(path, node), ("%s of '%s'"):format(what, node))
    if #self.problems.list == before then
      for i, value in ipairs(t[node]) do parts[i] = ("%.9g"):format(value) end
      result[#result + 1] = ("%s=%s"):format(node, table.concat(parts, ","))
    end
  end
  return result
end

local motions = { move = 3, spin = 4 }
local lua_types = { number = "number", integer = "number", choice = "string", text = "string", size = "table",
                    view = "table", texts = "table", bool = "boolean" }

-- Returns a number as text that reads back as the same number: with 15 digits if they suffice, otherwise with 17.
local function digits(value)
  local short = ("%.15g"):format(value)
  return tonumber(short) == value and short or ("%.17g"):format(value)
end

-- Returns a camera path, a list of keys { frame, eye x, y, z, target x, y, z }, as arguments of the command line. The target is
-- the point that the camera looks at.
function Methods:camera_path(keys, path)
  local result = {}
  for i, key in ipairs(type(keys) == "table" and keys or {}) do
    local before = #self.problems.list
    self:numbers(key, 7, check.joined(path, i), "a key of a camera path")
    if #self.problems.list == before then
      local parts = {}
      for k = 2, 7 do parts[k - 1] = digits(key[k]) end
      result[i] = ("%s=%s"):format(digits(key[1]), table.concat(parts, ","))
    end
  end
  if #result == 0 then self:add(path, "a camera path needs at least one key { frame, eye x, y, z, target x, y, z }") end
  return result
end

-- Checks the value of an option of a shot and returns it as plain data. `declared`: the declaration of the option, with its
-- name, type and range.
function Methods:option(declared, value, path, what)
  local name = declared.name
  local at = check.joined(path, name)
  if name == "path" then return self:camera_path(value, at) end
  if motions[name] then return self:motions(value, motions[name], at, name) end
  if type(value) ~= lua_types[declared.type] then
    self:add(at, "'%s' of %s is a %s instead of a %s", name, what, type(value), lua_types[declared.type])
  elseif declared.choices and #declared.choices > 0 then
    self:one_of(value, declared.choices, at, ("'%s' of %s"):format(name, what))
  elseif type(value) == "number" and not (value >= (declared.min or value) and value <= (declared.max or value)) then
    local range = ("%s to %s"):format(shown(declared.min), shown(declared.max))
    self:add(at, "'%s' of %s is %s, which is not in the range %s", name, what, shown(value), range)
  elseif declared.type == "integer" and not math.tointeger(value) then
    self:add(at, "'%s' of %s is %s, which is not a whole number", name, what, shown(value))
  end
  return value
end

-- Sorts the settings in `t` by their target, and returns three lists: `options` of the shot, parameters of its `scene` (written
-- "scene.NAME"), and `others`, such as parameters of a pipeline.
function Methods:sorted(t, path, what)
  local result = { options = {}, scene = {}, others = {} }
  local names = check.names(t)
  table.sort(names)
  for _, name in ipairs(names) do
    local scene, value, into = name:match("^scene%.(.+)$"), t[name], result.others
    if scene then into = result.scene end
    if self.options[name] then
      into, value = result.options, self:option(self.options[name], value, path, what)
    end
    into[#into + 1] = { name = scene or name, value = value, place = self:place_of(check.joined(path, name)) }
  end
  return result
end

function Methods:distinct(entries, key, group)
  local seen = {}
  for i, entry in ipairs(entries) do
    if entry[key] ~= nil and check.contains(seen, entry[key]) then
      self:add({ group, i, key }, "two of the %s are called '%s'", group, tostring(entry[key]))
    end
    seen[#seen + 1] = entry[key]
  end
  return seen
end

-- Checks the field `frames` of a shot, { from, to, step }: the frame numbers of a sequence of 2 to 1000 frames.
function Methods:sequence(frames, shot, path)
  if frames == nil then return end
  local good = type(frames) == "table" and #frames == 3
  for i = 1, good and 3 or 0 do good = good and math.tointeger(frames[i]) ~= nil end
  good = good and frames[1] >= 0 and frames[3] >= 1 and frames[2] >= frames[1] + frames[3]
  good = good and frames[2] < frames[1] + 1000 * frames[3]
  if not good then self:add(path, "frames must be { from, to, step }, three whole numbers for 2 to 1000 frames") end
  if shot.frame ~= nil then self:add(path, "a shot cannot have both frames and frame") end
end

function Methods:shot(t, path)
  local what, own, options = "shot " .. path[2], {}, {}
  if type(t) ~= "table" then own = t end
  for name, value in pairs(type(t) == "table" and t or {}) do
    local is_option = type(name) == "string" and (self.options[name] or name:find("^scene%."))
    local known = self.shot_fields[name]
    if known then own[name] = value elseif is_option then options[name] = value else
      local near = check.names(self.shot_fields)
      for option in pairs(self.options) do near[#near + 1] = option end
      table.sort(near)
      local nearest = native.nearest(tostring(name), near)
      self:add(check.joined(path, name), "%s has no field '%s'%s", what, tostring(name), nearest)
    end
  end
  local result = copied(self:fields(own, "shot", path, what))
  result.place = self:place_of(path)
  self:one_of(result.curve, shots.tones, check.joined(path, "curve"), "the curve")
  self:sequence(result.frames, options, check.joined(path, "frames"))
  for i, crop in ipairs(type(result.crops) == "table" and result.crops or {}) do
    local at = check.joined(check.joined(path, "crops"), i)
    if crop ~= "inner" then self:numbers(crop, 4, at, "a crop other than \"inner\"") end
  end
  result.truth = self:settings(result.truth, check.joined(path, "truth"))
  local sorted = self:sorted(options, path, what)
  result.options, result.scene_set = sorted.options, sorted.scene
  return result
end

-- Adds the methods of this file to `Checker`, a class of checkers made by strobe.fields. `shot_fields`: the declared fields of
-- a shot, besides the options of the command line. A user of these methods must set the field `options` of its checker to a
-- table of the options of the command line, by name (see `shots.by_name`).
function shots.extend(Checker, shot_fields)
  for name, method in pairs(Methods) do Checker[name] = method end
  Checker.shot_fields = shot_fields
end

-- Returns the list of the options of the command line as a table by name.
function shots.by_name(options)
  local result = {}
  for _, option in ipairs(options) do result[option.name] = option end
  return result
end

check.closed(shots, "shots")

return shots
