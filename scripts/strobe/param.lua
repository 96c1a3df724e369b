-- SPDX-License-Identifier: MIT
-- Parameters of passes and of pipelines. A script declares a parameter by a constructor, such as `int { 20, min = 1, max = 256,
-- doc = "..." }`. The constructor only stores the table and its place, because it runs before the name of the parameter is
-- known. `param.declare` checks the table later.
local check  = require "strobe.check"
local native = require "strobe.native"

local param = {}

param.keys = {
  bool   = { 1, "default", "doc", "unit", "role", "wired", "breaks" },
  int    = { 1, "default", "min", "max", "unit", "doc", "role", "wired", "variant", "breaks" },
  float  = { 1, "default", "min", "max", "unit", "doc", "role", "wired", "variant", "auto", "breaks" },
  choice = { "default", "doc", "unit", "role", "wired", "values", "breaks" },  -- the choices have the keys 1, 2, 3, ...
}

-- Reserved words of GLSL. A parameter with such a name would break the generated declarations of the shader.
local reserved = {}
for _, word in ipairs {
  "active", "asm", "bool", "break", "buffer", "case", "cast", "class", "common", "const", "continue", "default",
  "discard", "do", "double", "else", "enum", "extern", "external", "false", "filter", "fixed", "flat", "float", "for",
  "goto", "half", "if", "in", "inline", "inout", "input", "int", "interface", "invariant", "layout", "long",
  "namespace", "noinline", "out", "output", "packed", "partition", "patch", "precise", "precision", "public",
  "resource", "restrict", "return", "sample", "shared", "short", "sizeof", "smooth", "static", "struct", "subroutine",
  "superp", "switch", "template", "this", "true", "typedef", "uint", "uniform", "union", "unsigned", "using",
  "varying", "void", "volatile", "while",
} do reserved[word] = true end

local Param = check.index_of_records({}, "a parameter")

local function constructor(kind)
  return native.at_caller(function(place, given)
    if type(given) ~= "table" then check.fail(place, "%s takes a table: %s { ... }", kind, kind) end
    return param.new(kind, place, given)
  end)
end

function param.new(kind, place, given, origin)
  local made = setmetatable({ type = kind, given = given, place = place }, Param)
  made.origin = origin or made
  return made
end

-- Keys that a pass or a pipeline may change when it uses a shared parameter, as in `blur.tile { 16 }`. The changed declaration
-- still counts as a use of the same parameter.
param.changed_keys = {
  bool = { 1, "default", "doc", "wired", "breaks" },
  int = { 1, "default", "min", "max", "doc", "wired" },
  float = { 1, "default", "min", "max", "doc", "wired" },
  choice = { "default", "doc", "wired", "values", "breaks" },
}

Param.__call = native.at_caller(function(place, self, changes)
  if type(changes) ~= "table" then check.fail(place, "a parameter is changed by a table: tile { 16 }") end
  local problems = check.problems()
  check.keys(problems, changes, param.changed_keys[self.type], place, "a change of a shared parameter")
  problems:raise()
  local given = {}
  for key, value in pairs(self.given) do given[key] = value end
  if changes[1] ~= nil then given.default = nil end
  if changes.default ~= nil and self.type ~= "choice" then given[1] = nil end
  for key, value in pairs(changes) do given[key] = value end
  return param.new(self.type, place, given, self.origin)
end)

param.bool, param.int = constructor "bool", constructor "int"
param.float, param.choice = constructor "float", constructor "choice"

function param.is_param(value)
  return getmetatable(value) == Param
end

local function check_choices(problems, given, place, what)
  local choices = {}
  for i, name in ipairs(given) do
    if type(name) ~= "string" or not name:find("^[a-z0-9_]+$") then
      problems:add(place, "choice %d of %s is %s, not a name of a-z, 0-9 and _", i, what, check.quoted(name))
    elseif check.contains(choices, name) then
      problems:add(place, "%s has the choice '%s' twice", what, name)
    else
      choices[#choices + 1] = name
    end
  end
  if #given == 0 then problems:add(place, "%s has no choices", what) end
  return choices
end

-- Checks `values = { CHOICE = "text" }`, the texts that describe the effect and the failures of each choice. Returns the valid
-- entries.
local function check_values(problems, given, choices, place, what)
  local values = {}
  if given.values == nil or not check.field(problems, given, "values", "table", place, what) then return values end
  for name, text in pairs(given.values) do
    local at = native.key_place(place, "values", name)
    if not check.contains(choices, name) then
      local near = type(name) == "string" and native.nearest(name, choices) or ""
      problems:add(at, "values of %s describes %s, which is not a choice%s", what, check.quoted(name), near)
    elseif type(text) ~= "string" or not text:find("%S") then
      problems:add(at, "choice '%s' of %s is described by %s instead of a text", name, what, check.quoted(text))
    else
      values[name] = text
    end
  end
  return values
end

-- Largest value of a number in a shader, by the type of the parameter: a 32-bit integer or a single-precision float.
local LARGEST = { int = 2147483647, float = 3.4028234e38 }

-- Checks `breaks = { VALUE = { INVARIANT = "reason" } }`, the invariants (docs/invariants.md) that do not hold for a value of
-- the parameter. `choices`: the keys that are allowed for VALUE. A choice parameter has its choices as keys, and a bool has
-- "true" and "false". A number has the key "other", which stands for every value except the default.
local function check_breaks(problems, given, choices, place, what)
  if given.breaks == nil or not check.field(problems, given, "breaks", "table", place, what) then return nil end
  local breaks = {}
  for value, list in pairs(given.breaks) do
    if not check.contains(choices, value) then
      local near = type(value) == "string" and native.nearest(value, choices) or ""
      local at = native.key_place(place, "breaks", value)
      problems:add(at, "'breaks' of %s names %s, which is not one of its values%s", what, check.quoted(value), near)
    else
      breaks[value] = check.breaks(problems, list, place, ("'%s' of %s"):format(value, what), { "breaks", value })
    end
  end
  return next(breaks) and breaks or nil
end

local function check_bounds(problems, result, given, place, what)
  for _, key in ipairs { "min", "max" } do
    local bound = given[key]
    local function wrong(...) problems:add(native.key_place(place, key), ...) end
    local finite = type(bound) == "number" and bound == bound and math.abs(bound) < math.huge
    if bound == nil then
      wrong("%s has no '%s'; every number needs a range", what, key)
    elseif not finite then
      wrong("'%s' of %s is %s, not a number", key, what, check.quoted(bound))
    elseif result.type == "int" and not math.tointeger(bound) then
      wrong("'%s' = %s of %s is not an integer", key, bound, what)
    elseif math.abs(bound) > LARGEST[result.type] then
      wrong("'%s' = %s of %s is more than a shader's %s can hold (%s)", key, bound, what, result.type,
            LARGEST[result.type])
    else
      result[key] = result.type == "int" and math.tointeger(bound) or bound + 0.0
    end
  end
  if result.min and result.max and result.min > result.max then
    problems:add(native.key_place(place, "min"), "%s has min %s above max %s", what, given.min, given.max)
  end
end

local roles = native.roles()

-- Checks the role of a parameter, one of native.roles(), and returns it; nil without a role. A role marks the purpose of a
-- parameter. Commands find parameters by their roles, so the names of parameters are free.
local function check_role(problems, given, place, what)
  if given.role == nil then return nil end
  if check.contains(roles, given.role) then return given.role end
  local near = type(given.role) == "string" and native.nearest(given.role, roles) or ""
  if near == "" then near = "; roles are " .. table.concat(roles, ", ") end
  problems:add(native.key_place(place, "role"), "%s has no known role: %s%s", what, check.quoted(given.role), near)
  return nil
end

-- A shared parameter may be declared once and used, with changes, by many passes and pipelines. Its first declaration is the
-- origin of all these uses. `origins`: checked declaration -> its origin. `of_passes`: the set of the origins of all parameters
-- of passes.
local origins, of_passes = setmetatable({}, { __mode = "k" }), {}

-- True if two checked declarations are uses of one parameter: they have the same origin.
function param.same(a, b)
  return origins[a] ~= nil and origins[a] == origins[b]
end

-- Records that a pass has the parameters in `list`. A parameter of a pipeline counts as used if its origin is the
-- origin of a recorded parameter.
function param.note_pass(list)
  for _, one in ipairs(list) do of_passes[origins[one]] = true end
end

function param.is_of_a_pass(declared)
  return of_passes[origins[declared]] == true
end

-- Cache: declaration -> its checked copy, for declarations without mistakes. Many passes share a parameter, which is then
-- checked once.
local checked = setmetatable({}, { __mode = "k" })

local function copy_of(declaration)
  local copy = {}
  for key, value in pairs(declaration) do copy[key] = value end
  origins[copy] = origins[declaration]
  return copy
end

-- Checks `declared`, the declaration of the parameter `name` of `owner`, and returns it as plain data; nil after a mistake.
-- `at`: place where the script names the parameter.
function param.declare(problems, name, declared, at, owner)
  local same = checked[declared]
  if same and same.name == name then return copy_of(same) end
  local before = #problems.list
  if not check.is_name(name) then
    problems:add(at, "%s is not a name for a parameter (a-z, then a-z, 0-9 and _)", check.quoted(name))
    return nil
  end
  local what = "parameter '" .. name .. "' of " .. owner
  if not param.is_param(declared) then
    problems:add(at, "%s is a %s; declare it with int { }, float { }, bool { } or choice { }", what, type(declared))
    return nil
  end
  local given, place, kind = declared.given, declared.place, declared.type
  if reserved[name] then problems:add(place, "'%s' is a reserved word of GLSL", name) end

  local known = { table.unpack(param.keys[kind]) }
  for i = 1, kind == "choice" and #given or 0 do known[#known + 1] = i end
  check.keys(problems, given, known, place, what)

  local result = { name = name, type = kind, place = place, unit = "", variant = kind == "bool" or kind == "choice" }
  result.doc = check.doc(problems, given, place, what)
  result.role = check_role(problems, given, place, what)
  if given.unit ~= nil and check.field(problems, given, "unit", "string", place, what) then result.unit = given.unit end
  if given.variant ~= nil and check.field(problems, given, "variant", "boolean", place, what) then
    result.variant = given.variant
  end
  if given.wired ~= nil and check.field(problems, given, "wired", "boolean", place, what) then
    result.wired = given.wired
  end
  if given.auto ~= nil and check.field(problems, given, "auto", "boolean", place, what) then
    result.auto = given.auto
    if given.auto and type(given.min) == "number" and given.min < 0 then
      problems:add(native.key_place(place, "auto"), "%s accepts auto, which is stored as -1, so its 'min' must be at least 0",
                   what)
    end
  end
  if kind == "choice" then
    result.choices = check_choices(problems, given, place, what)
    result.values = check_values(problems, given, result.choices, place, what)
  end
  local breaking = result.choices or (kind == "bool" and { "true", "false" } or { "other" })
  result.breaks = check_breaks(problems, given, breaking, place, what)
  if kind == "int" or kind == "float" then check_bounds(problems, result, given, place, what) end
  if #problems.list > before then return nil end

  result.default = given.default
  if result.default == nil then result.default = given[1] end
  if result.default == nil then
    problems:add(place, "%s has no default", what)
    return nil
  end
  local value, wrong = param.check(result, result.default)
  if wrong then
    problems:add(native.key_place(place, "default"), "default of %s: %s", what, wrong)
    return nil
  end
  result.default = value
  origins[result] = declared.origin
  checked[declared] = copy_of(result)
  return result
end

-- Returns `value` in the canonical form of the parameter's type, or nil and a message. A text is refused unless the parameter
-- is a choice (or accepts "auto"). On the command line all values are texts; there, native.check_value converts them.
function param.check(declared, value)
  if type(value) == "string" and declared.type ~= "choice" and not (declared.auto and value == "auto") then
    return nil, ("'%s' = '%s' is a text instead of a value of type %s"):format(declared.name, value, declared.type)
  end
  return native.check_value(declared, value)
end

-- Checks the declarations of all parameters in the table `declared`, and returns them as a list, sorted by name.
function param.declare_all(problems, declared, place, owner)
  local list = {}
  for name, one in pairs(declared) do
    local at = native.key_place(place, "params", name)
    list[#list + 1] = param.declare(problems, name, one, at, owner)
  end
  param.refuse_twins(problems, list, owner)
  return list
end

-- Reports parameters with equal roles. Commands find a parameter by its role, so a role must identify one parameter.
function param.refuse_twins(problems, list, owner)
  local by_role = {}
  for _, one in ipairs(list) do
    local other = one.role and by_role[one.role]
    if other then
      problems:add(one.place, "'%s' and '%s' of %s have the same role, %s", other.name, one.name, owner,
                   check.quoted(one.role))
    end
    if one.role then by_role[one.role] = one end
  end
end

-- Returns the first declaration with the name `name` in a list, or nil. The names of a list are indexed at the first call,
-- because a list is searched thousands of times.
local indices = setmetatable({}, { __mode = "k" })
function param.find(list, name)
  local index = indices[list]
  if not index or index.count ~= #list then
    index = { count = #list, by_name = {} }
    for i = #list, 1, -1 do index.by_name[list[i].name] = list[i] end
    indices[list] = index
  end
  return index.by_name[name]
end

return param
