// SPDX-License-Identifier: MIT
// The Lua part of the sandbox: replacements of library functions whose results differ between processes (order of keys,
// addresses, unseeded random numbers), and errors for unknown globals.
#pragma once

namespace strobe::script {

inline constexpr const char* kPrelude = R"lua(
local native = ...
local raw_next, raw_format, raw_tostring, sort = next, string.format, tostring, table.sort
local type, error, pcall, rawset, getmetatable = type, error, pcall, rawset, getmetatable
local setmetatable, select, unpack, find, stderr_write = setmetatable, select, table.unpack, string.find, native.write

local safe = {}

function safe.tostring(value)
  local kind = type(value)
  if kind == "string" or kind == "number" or kind == "boolean" or kind == "nil" then return raw_tostring(value) end
  local meta = getmetatable(value)
  if type(meta) == "table" and meta.__tostring then return raw_tostring(value) end
  return kind
end

function safe.format(text, ...)
  local arguments, count = { ... }, select("#", ...)
  for i = 1, count do
    local kind = type(arguments[i])
    if kind ~= "number" and kind ~= "string" and kind ~= "boolean" then arguments[i] = safe.tostring(arguments[i]) end
  end
  if type(text) == "string" and find(text, "%%%-?%d*p") then error("%p would print an address", 2) end
  local good, result = pcall(raw_format, text, unpack(arguments, 1, count))
  if not good then error(result, 2) end
  return result
end

function safe.print(...)
  local line = ""
  for i = 1, select("#", ...) do line = line .. (i > 1 and "\t" or "") .. safe.tostring((select(i, ...))) end
  stderr_write(line .. "\n")
end

local raw_randomseed = math.randomseed
raw_randomseed(0)
local function randomseed(seed, ...)
  if type(seed) ~= "number" then error("math.randomseed needs a number", 2) end
  raw_randomseed(seed, ...)
end

string.format, string.dump = safe.format, nil
math.randomseed = randomseed

local env = {
  _VERSION = _VERSION, assert = assert, error = error, getmetatable = getmetatable, ipairs = ipairs, math = math,
  next = native.next, pairs = native.pairs, pcall = pcall, print = safe.print, rawequal = rawequal, rawget = rawget,
  rawlen = rawlen, select = select, setmetatable = setmetatable, string = string, table = table, tonumber = tonumber,
  tostring = safe.tostring, type = type, utf8 = utf8, require = native.require, caller_place = native.caller_place,
}

local function names()
  local list = {}
  for key in raw_next, env do list[#list + 1] = key end
  sort(list)
  return list
end

function env.rawset(t, key, value)
  if t == env then error("a global cannot be set", 2) end
  return rawset(t, key, value)
end

function native.define(name, value) rawset(env, name, value) end

return setmetatable(env, {
  __metatable = false,
  __index = function(_, name)
    error("unknown global '" .. safe.tostring(name) .. "'" .. native.nearest(safe.tostring(name), names()), 2)
  end,
  __newindex = function(_, name)
    name = safe.tostring(name)
    error("global '" .. name .. "' is assigned but not declared; write 'local " .. name .. "'", 2)
  end,
})
)lua";

}  // namespace strobe::script
