// SPDX-License-Identifier: MIT
// Functions of the sandbox that Lua calls.
#pragma once

#include "script/sandbox.h"

namespace strobe::script {

// Keys in the registry of a state: the environment of scripts, and the modules that `require` has loaded.
inline constexpr const char *kEnvironment = "strobe.environment", *kLoaded = "strobe.loaded";

// The sandbox of a Lua state.
inline Sandbox& self(lua_State* lua) { return **static_cast<Sandbox**>(lua_getextraspace(lua)); }

struct Sandbox::Callbacks {
  struct Native;
  static const luaL_Reg* native();  // the functions of the module strobe.native
  // Compiles `source_` and keeps the function in the registry, with the number `ready_chunk_`.
  static int keepChunk(lua_State* lua);
  // Error message: unchanged, or preceded by the place of the user's line if the error was raised in the library.
  static int message(lua_State* lua);
};

}  // namespace strobe::script
