// SPDX-License-Identifier: MIT
// Plain data between Lua and JSON.
#pragma once

#include <lua.hpp>

#include "base/json_fwd.h"

namespace strobe::script {

// Pushes `json`. To be called where Lua may raise an error (out of memory) past no destructor: see `Sandbox`.
void pushJson(lua_State* lua, const Json& json);

// The value at `index`. A table with entries 1..n is an array, as is an empty one; else an object with sorted keys.
// Throws `Error` naming the key of anything that is no plain data: a function, a number that is not finite, a table
// inside itself, keys that are neither text nor 1..n. Raises no Lua error.
Json jsonAt(lua_State* lua, int index);

}  // namespace strobe::script
