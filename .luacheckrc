-- SPDX-License-Identifier: MIT
-- For luacheck (the package lua-check of Debian): Lua 5.4 as the sandbox of scripts has it (runtime/script/prelude.lua.h).
std = {
  read_globals = {
    "_ENV", "_VERSION", "assert", "caller_place", "error", "getmetatable", "ipairs", "math", "next", "pairs", "pcall",
    "print", "rawequal", "rawget", "rawlen", "rawset", "require", "scene_params", "select", "setmetatable", "string",
    "table", "tonumber", "tostring", "type", "utf8",
  },
}
max_line_length = 128
cache = false
exclude_files = { "experiments/*/.*" }  -- what a sweep reads while it runs

-- Declarations for editors: functions without bodies.
files["scripts/types.lua"] = { ignore = { "1..", "2.." }, globals = { "scene_params", "caller_place" }, max_line_length = 140 }
