-- SPDX-License-Identifier: MIT
-- Tools for checks of declarations. They collect the mistakes of a table and raise one error for all of these mistakes. Each
-- mistake has a `place`, { file, line }, in the user's script. The module strobe.native, which this library uses, has functions
-- of the C++ runtime; a place comes from its functions `at_caller`, `key_place` and `return_place`.
local native = require "strobe.native"

local check = {}

local invariants = native.invariants()

local Problems = {}
Problems.__index = Problems

function check.problems()
  return setmetatable({ list = {} }, Problems)
end

-- Adds a mistake at `place`. The message is `text`, formatted with the values after it by string.format.
function Problems:add(place, text, ...)
  self.list[#self.list + 1] = { place = { file = place.file, line = place.line }, message = text:format(...) }
end

function Problems:raise()
  if #self.list > 0 then error({ problems = self.list }, 0) end
end

-- Raises an error with one mistake.
function check.fail(place, text, ...)
  local problems = check.problems()
  problems:add(place, text, ...)
  problems:raise()
end

function check.is_name(value)
  return type(value) == "string" and #value <= 64 and value:find("^[a-z][a-z0-9_]*$") ~= nil
end

-- True if `value` is a text of names that are separated by slashes, such as "gather/uniform".
function check.is_path(value)
  if type(value) ~= "string" or value:find("^/") or value:find("/$") then return false end
  for part in value:gmatch("[^/]+") do
    if not check.is_name(part) then return false end
  end
  return not value:find("//", 1, true)
end

-- Merges `t` and the tables in its list part into one table. A later table in the list overrides an earlier one, and the named
-- fields of `t` override all tables. `t` may be `{ options.blur, { a = 1 } }` or `{ options.blur, a = 1 }`, for example.
function check.merged(t)
  if t[1] == nil then return t end
  local result = {}
  for i, part in ipairs(t) do
    if check.is_plain(part) then
      for key, value in pairs(check.merged(part)) do result[key] = value end
    else
      result[i] = part  -- an entry that is not a plain table stays at its index, so that a later check reports it
    end
  end
  for key, value in pairs(t) do
    if type(key) ~= "number" then result[key] = value end
  end
  return result
end

-- Merges the tables in the list part of `t[key]` into one. Returns a copy of `t` with the merged table. If `t[key]` has no list
-- part, returns `t` itself.
function check.with_merged(t, key)
  if type(t[key]) ~= "table" or t[key][1] == nil then return t end
  local copy = {}
  for name, value in pairs(t) do copy[name] = value end
  copy[key] = check.merged(t[key])
  return copy
end

-- True if the texels or entries of the format `format` are unsigned integers.
function check.is_uint(format)
  return format:find("ui$") ~= nil
end

-- True if the format `format` declares a buffer of unsigned integers instead of an image.
function check.is_buffer(format)
  return format == "buffer32ui"
end

function check.contains(list, value)
  for i = 1, #list do  -- faster than ipairs, which calls a function per entry; there are thousands of lookups
    if list[i] == value then return true end
  end
  return false
end

-- Returns the string keys of a table. They are sorted, because `pairs` of Strobe's interpreter visits the keys of a table in
-- sorted order.
function check.names(t)
  local names = {}
  for key in pairs(t) do
    if type(key) == "string" then names[#names + 1] = key end
  end
  return names
end

function check.quoted(value)
  return type(value) == "string" and ("'%s'"):format(value) or tostring(value)
end

-- Reports every key of `t` that is not in the list `known`. `place`: place of the call in the user's script that has the table
-- as its argument. `path`: keys that lead from this argument to `t`; default: the argument is `t`. `what`: name of `t` in
-- messages.
function check.keys(problems, t, known, place, what, path)
  if type(t) == "table" and not native.has_other_keys(t, known) then return end
  path = path or {}
  for key in pairs(t) do
    if not check.contains(known, key) then
      local where = native.key_place(place, table.unpack(check.joined(path, key)))
      local near = type(key) == "string" and native.nearest(key, known) or ""
      problems:add(where, "%s has no field %s%s", what, check.quoted(key), near)
    end
  end
end

function check.joined(path, key)
  local longer = { table.unpack(path) }
  longer[#longer + 1] = key
  return longer
end

-- True if the type of `t[key]` is `kind`, a type name of Lua. Otherwise reports a mistake. The other arguments are as for
-- `check.keys`: `place` and `path` locate `t`, and `what` names `t` in messages.
function check.field(problems, t, key, kind, place, what, path)
  if type(t[key]) == kind then return true end
  local where = native.key_place(place, table.unpack(check.joined(path or {}, key)))
  local article = kind == "function" and "a function" or (kind == "string" and "a text" or "a " .. kind)
  if t[key] == nil then
    problems:add(where, "%s has no '%s', which must be %s", what, key, article)
  else
    problems:add(where, "'%s' of %s is a %s instead of %s", key, what, type(t[key]), article)
  end
  return false
end

-- Returns the text `t.doc`. If the text is missing or empty, reports a mistake and returns "".
function check.doc(problems, t, place, what, path)
  if type(t.doc) == "string" and t.doc:find("%S") then return t.doc end
  local where = native.key_place(place, table.unpack(path or {}))
  problems:add(where, "%s has no 'doc', a text that describes it", what)
  return ""
end

-- Checks `given`, a field `breaks = { INVARIANT = "reason" }`, and returns its valid entries, or nil if all are invalid. The
-- field lists the invariants (docs/invariants.md) that a pass, a pipeline or a value of a parameter does not keep. `path`: keys
-- that lead from the argument of the call at `place` to `given`.
function check.breaks(problems, given, place, what, path)
  if given == nil then return nil end
  local at = native.key_place(place, table.unpack(path))
  if type(given) ~= "table" then
    problems:add(at, "'breaks' of %s is a %s instead of a table { invariant = \"reason\" }", what, type(given))
    return nil
  end
  local known, result = invariants, {}
  for name, reason in pairs(given) do
    local where = native.key_place(place, table.unpack(check.joined(path, name)))
    if not check.contains(known, name) then
      local near = type(name) == "string" and native.nearest(name, known) or ""
      if near == "" then near = "; the invariants are " .. table.concat(known, ", ") end
      problems:add(where, "%s breaks %s, which is not an invariant%s", what, check.quoted(name), near)
    elseif type(reason) ~= "string" or not reason:find("%S") then
      problems:add(where, "%s breaks '%s' without a text that states the reason", what, name)
    else
      result[name] = reason
    end
  end
  return next(result) and result or nil
end

local no_field = native.at_caller(function(place, what, key, known)
  local near = native.nearest(key, known)
  if near == "" and #known > 0 then
    table.sort(known)
    near = "; it has " .. table.concat(known, ", ")
  end
  check.fail(place, "%s has no %s%s", what, check.quoted(key), near)
end)

-- Completes the metatable `meta` for records and returns it. A record is a table that is protected against misspelt names:
-- reading a named field that it lacks is an error at the line that reads the field. The names in the list `optional` are
-- excepted and read as nil. `what` names the record in messages.
function check.index_of_records(meta, what, optional)
  local may_lack = {}
  for _, name in ipairs(optional or {}) do may_lack[name] = true end
  function meta.__index(t, key)
    if type(key) ~= "string" or may_lack[key] then return nil end
    if key == "get" and meta.is_record then return rawget end
    local known = check.names(t)
    for name in pairs(may_lack) do
      if rawget(t, name) == nil then known[#known + 1] = name end
    end
    return no_field(what, key, known)
  end
  return meta
end

-- True if `value` is a plain table: a table without a metatable, or a record made by `check.record`.
function check.is_plain(value)
  local meta = getmetatable(value)
  return type(value) == "table" and (meta == nil or meta.is_record == true)
end

-- Returns a function that turns a table into a record: reading an unknown field of a record is an error. `what` names the
-- record in messages, and `optional` lists the fields that may be absent. Example: `local layer = check.record("a layer",
-- { "curve" })`, then `layer { depth = ... }`.
function check.record(what, optional)
  local meta = check.index_of_records({ is_record = true }, what, optional)
  return function(t) return setmetatable(t, meta) end
end

-- Protects the table of a module against misspelt names: reading a field that it lacks becomes an error at the line that reads
-- the field. Returns the module. `name` names the module in messages.
function check.closed(module, name)
  return setmetatable(module, check.index_of_records(getmetatable(module) or {}, "the module " .. name))
end

return check
