-- SPDX-License-Identifier: MIT
-- Checks of tables with typed fields, such as the tables of experiments and captures. All mistakes of a table are collected, so
-- that they can be reported together.
local check  = require "strobe.check"
local native = require "strobe.native"

-- Types that a field may declare: a type name of Lua, which the value must have, or "list" or "map" (both a Lua table), or
-- "any".
local fields = { text = "string", number = "number", bool = "boolean", list = "list", map = "map", func = "function",
                 any = "any" }

-- Returns a class of checkers, objects that check one table of the user and collect its mistakes. `declared` has the fields of
-- each kind of table: KIND = { FIELD = { type, optional = true or nil } }. `Checker.at(place)` makes a checker for the table at
-- `place` in the user's script. A mistake is added with a `path`, the keys that lead from this table to the wrong value.
function fields.checker(declared)
  local Checker = {}
  Checker.__index = Checker

  function Checker.at(place) return setmetatable({ place = place, problems = check.problems() }, Checker) end

  function Checker:add(path, ...) self.problems:add(native.key_place(self.place, table.unpack(path)), ...) end

  -- Checks the fields of the table `t`, of the kind `kind`, and returns `t`. Returns an empty table if `t` is not a table.
  -- `what` names the table in messages.
  function Checker:fields(t, kind, path, what)
    what = what or "the " .. kind
    if type(t) ~= "table" then
      self:add(path, "%s must be a table, got a %s", what, type(t))
      return {}
    end
    check.keys(self.problems, t, check.names(declared[kind]), self.place, what, path)
    for name, field in pairs(declared[kind]) do
      local wanted = (field[1] == fields.list or field[1] == fields.map) and "table" or field[1]
      if wanted ~= fields.any and (t[name] ~= nil or not field.optional) then
        check.field(self.problems, t, name, wanted, self.place, what, path)
      end
    end
    return t
  end

  function Checker:one_of(value, allowed, path, what)
    if value == nil or check.contains(allowed, value) then return end
    local near = type(value) == "string" and native.nearest(value, allowed) or ""
    self:add(path, "%s is %s, which is not one of %s%s", what, check.quoted(value), table.concat(allowed, ", "), near)
  end

  -- Calls the function `one(entry, i, path)` for each entry of the list t[name], and returns the list of its results. `i` is
  -- the index of the entry, and `path` is { name, i }.
  function Checker:each(t, name, one)
    local result = {}
    if type(t[name]) ~= "table" then return result end
    if #t[name] == 0 then self:add({ name }, "there are no %s", name) end
    for i, entry in ipairs(t[name]) do result[i] = one(entry, i, { name, i }) end
    return result
  end

  return Checker
end

-- Returns a value as text for messages and labels, in a form that the command line accepts.
function fields.shown(value) return math.type(value) == "float" and ("%.14g"):format(value) or tostring(value) end

function fields.copied(t)
  local result = {}
  for key, value in pairs(t) do result[key] = value end
  return result
end

check.closed(fields, "fields")

return fields
