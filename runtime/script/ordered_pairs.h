// SPDX-License-Identifier: MIT
// Lua's `pairs` and `next` in an order that is the same in every process: false, true, numbers, strings.
#pragma once

#include <lua.hpp>

namespace strobe::script {

// pairs(t). Keys that have gone by their turn are left out; keys of other types are an error at the caller's line.
int orderedPairs(lua_State* lua);

// next(t): the first pair, or nil.
int firstPair(lua_State* lua);

}  // namespace strobe::script
