-- SPDX-License-Identifier: MIT
-- Checks the field `if_no` of a pass, such as `if_no = { motion = { blurred = "color" }, mask = { color = 0, depth = 0 } }`. It
-- declares stand-ins: images or zeros that replace the writes of the pass if the pass need not run.
-- A key of `if_no` is one of these: a fact of the frame (the pass does not run if the fact is false); a read of the pass (the
-- pass does not run if the read has only zeros); or `moving_rect` (the pass runs in the moving rectangle only, and the
-- stand-ins fill all other pixels).
local check  = require "strobe.check"
local native = require "strobe.native"

local stand_in = {}

local function port_named(ports, name)
  for _, port in ipairs(ports) do
    if port.name == name then return port end
  end
  return nil
end

local function names_of(ports, names)
  for _, port in ipairs(ports) do names[#names + 1] = port.name end
  return names
end

local function near(name, names)
  return type(name) == "string" and native.nearest(name, names) or ""
end

-- Checks a key of `if_no`: the name of a fact or a read, or `moving_rect`.
local function check_name(problems, name, reads, at, owner)
  local facts = native.facts()
  facts[#facts + 1] = "moving_rect"
  local is_fact, is_read = check.contains(facts, name), type(name) == "string" and port_named(reads, name) ~= nil
  if is_fact and is_read then
    problems:add(at, "if_no '%s' of %s names both a fact and a read; rename the read", name, owner)
  elseif not is_fact and not is_read then
    local names = names_of(reads, facts)
    problems:add(at, "if_no of %s names %s, which is neither a fact nor a read of the pass%s", owner, check.quoted(name),
                 near(name, names))
  end
end

-- Checks `given`, the stand-in of one write: 0, or the name of a read that is always wired and has texels of the same kind.
local function check_stand_in(problems, write, given, reads, at, what)
  if given == 0 then return end
  local read = type(given) == "string" and port_named(reads, given)
  if given == nil then
    problems:add(at, "%s has no stand-in for '%s'; a stand-in is 0 or the name of a read", what, write.name)
  elseif not read then
    problems:add(at, "%s: '%s' is %s, which is neither 0 nor a read of the pass%s", what, write.name, check.quoted(given),
                 near(given, names_of(reads, {})))
  elseif read.optional then
    problems:add(at, "%s: '%s' is '%s', which is optional and may be absent", what, write.name, given)
  elseif write.format and check.is_buffer(write.format) ~= read.buffer then
    problems:add(at, "%s: '%s' and '%s' are not both buffers", what, write.name, given)
  elseif write.format and check.is_uint(write.format) ~= read.uint then
    problems:add(at, "%s: '%s' and '%s' do not both hold unsigned integers", what, write.name, given)
  end
end

local function declare_one(problems, name, given, result, place, owner)
  local at = native.key_place(place, "if_no", name)
  local what = ("if_no %s of %s"):format(check.quoted(name), owner)
  check_name(problems, name, result.reads, at, owner)
  if type(given) ~= "table" then
    problems:add(at, "%s is a %s instead of a table like { color = 0 }", what, type(given))
    return nil
  end
  check.keys(problems, given, names_of(result.writes, {}), place, what, { "if_no", name })
  for _, write in ipairs(result.writes) do
    local where = given[write.name] == nil and at or native.key_place(place, "if_no", name, write.name)
    check_stand_in(problems, write, given[write.name], result.reads, where, what)
  end
  return { name = name, place = at, writes = given }
end

-- Checks `given`, the field `if_no` of the pass `result`, and returns it as a list; nil without this field. The reads, writes
-- and updates of `result` must have been checked before.
function stand_in.declare(problems, given, result, place, owner)
  if given == nil then return nil end
  if next(result.updates) ~= nil then
    problems:add(native.key_place(place, "if_no"), "%s has updates, so it cannot have if_no", owner)
  end
  local list = {}
  for name, writes in pairs(given) do list[#list + 1] = declare_one(problems, name, writes, result, place, owner) end
  return list
end

check.closed(stand_in, "stand_in")

return stand_in
