-- SPDX-License-Identifier: MIT
-- Presets: named sets of values for the parameters of a pipeline. A pipeline declares presets of its own. A preset may also be
-- in a file, which contains `return preset { doc = "...", set = { tile = 16 } }` and is chosen by `--set preset=FILE.lua`. Its
-- values are checked against the parameters of the pipeline that it is used with.
local check  = require "strobe.check"
local native = require "strobe.native"
local param  = require "strobe.param"

local preset = {}

preset.keys = { "doc", "set" }

local Preset = {}  -- a preset in a file: { given = the table of the call preset { ... }, place = line of the call }

setmetatable(preset, { __call = native.at_caller(function(place, _, t)
  if type(t) ~= "table" then check.fail(place, "preset takes a table: preset { doc = \"...\", set = { ... } }") end
  return setmetatable({ given = t, place = place }, Preset)
end) })
check.closed(preset, "preset")

-- Checks `set`, the parameter values of a preset, and returns the valid values by name. `path`: keys that lead from the call at
-- `place` to `set`.
local function values_of(problems, what, set, params, place, path)
  local names, values = {}, {}
  for i, one in ipairs(params) do names[i] = one.name end
  for name, value in pairs(set) do
    local where = native.key_place(place, table.unpack(check.joined(path, name)))
    local declared = param.find(params, name)
    local wrong
    if declared then values[name], wrong = param.check(declared, value) end
    if wrong then problems:add(where, "%s: %s", what, wrong) end
    if not declared then
      local near = type(name) == "string" and native.nearest(name, names) or ""
      problems:add(where, "%s sets %s, which is not a parameter%s", what, check.quoted(name), near)
    end
  end
  return values
end

-- Checks the table `given` of a preset, { doc =, set = }, and returns the preset. `path`: keys that lead from the call at
-- `place` to `given`.
local function declared_by(problems, name, given, params, place, path)
  local what = ("preset '%s'"):format(name)
  check.keys(problems, given, preset.keys, place, what, path)
  local result = { name = name, default = false, values = {}, doc = check.doc(problems, given, place, what, path) }
  if check.field(problems, given, "set", "table", place, what, path) then
    result.values = values_of(problems, what, check.merged(given.set), params, place, check.joined(path, "set"))
  end
  return result
end

local function declare(problems, name, given, params, place)
  local at = native.key_place(place, "presets", name)
  if not check.is_name(name) then problems:add(at, "%s is not a name for a preset", check.quoted(name)) end
  if type(given) ~= "table" then
    problems:add(at, "preset %s is a %s instead of a table { doc = \"...\", set = { ... } }", check.quoted(name),
                 type(given))
    return nil
  end
  return declared_by(problems, tostring(name), given, params, place, { "presets", name })
end

-- Returns the preset "none", which sets no parameter: every parameter has its default.
local function none()
  return { name = "none", doc = "every parameter has its default", default = true, values = {} }
end

-- Checks the presets of a pipeline and returns them as a list. The field `default_preset` names the preset that is used if no
-- preset is chosen. Without this field, a preset "none" that sets no parameter is added and is the default.
function preset.declare_all(problems, t, params, place)
  local list, names = {}, {}
  if t.presets == nil then return list end
  if t.default_preset == nil then list[1] = none() end
  for name, given in pairs(t.presets) do
    names[#names + 1] = name
    local one = declare(problems, name, given, params, place)
    if one then one.default = name == t.default_preset end
    list[#list + 1] = one
  end
  if t.default_preset ~= nil and not check.contains(names, t.default_preset) then
    local near = native.nearest(t.default_preset, names)
    problems:add(native.key_place(place, "default_preset"), "unknown preset %s%s", check.quoted(t.default_preset),
                 near)
  end
  return list
end

-- ---- the preset of a setting

local function is_file(value) return type(value) == "string" and value:find("%.lua$") ~= nil end

function preset.is_set_by(set, presets) return set.name == "preset" and (#presets > 0 or is_file(set.value)) end

-- Returns the name of the preset that is used if no preset is chosen; nil if the list is empty.
function preset.default_of(presets)
  for _, one in ipairs(presets) do
    if one.default then return one.name end
  end
  return nil
end

-- Runs the preset file that `--set preset=FILE.lua` names, and appends its preset to a copy of `presets`. Returns the copy and
-- the name of the added preset. If the file does not exist, returns nil, nil and a message.
local function with_file(problems, presets, params, name)
  local there, given, shown = native.preset()
  if not there then return nil, nil, ("preset file '%s' does not exist"):format(name) end
  if getmetatable(given) ~= Preset then
    problems:add({ file = shown, line = 0 }, "returns %s instead of preset { ... } of strobe.preset",
                 given == nil and "nothing" or "a " .. type(given))
    return nil
  end
  local list = { table.unpack(presets) }
  if #list == 0 then list[1] = none() end
  list[#list + 1] = declared_by(problems, name, given.given, params, given.place, {})
  return list, name
end

-- Resolves the setting `--set preset=VALUE`. Returns the list of presets and the name of the chosen preset. After a mistake the
-- name is nil, and the third result is the message, unless `problems` already has it.
function preset.taken(problems, presets, params, value)
  if is_file(value) then return with_file(problems, presets, params, value) end
  local choice = { name = "preset", type = "choice", choices = {}, unit = "" }
  for i, one in ipairs(presets) do choice.choices[i] = one.name end
  local name, wrong = native.check_value(choice, value)
  return presets, name, wrong
end

return preset
