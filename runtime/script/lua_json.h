// SPDX-License-Identifier: MIT
// Conversion of plain data between Lua and JSON.
#pragma once

#include <lua.hpp>

#include "base/json_fwd.h"

namespace strobe::script {

// Pushes `json`. May raise a Lua error (out of memory), which skips destructors; see `Sandbox` for the callers.
void pushJson(lua_State* lua, const Json& json);

// The value at `index`. A table with entries 1..n and an empty table become an array; other tables become an object
// with sorted keys. Throws `Error` naming the key of a value that is not plain data: a function, a number that is not
// finite, a table inside itself, keys that are neither text nor 1..n. Does not raise Lua errors.
Json jsonAt(lua_State* lua, int index);

}  // namespace strobe::script
