// SPDX-License-Identifier: MIT
// Lua's `pairs` and `next` with the same order in every process: false, true, numbers, strings.
#pragma once

#include <lua.hpp>

namespace strobe::script {

// pairs(t). Keys that are removed during the loop are skipped. Keys of other types are an error at the caller's line.
int orderedPairs(lua_State* lua);

// next(t): the first pair, or nil.
int firstPair(lua_State* lua);

}  // namespace strobe::script
