// SPDX-License-Identifier: MIT
// What Lua calls of the sandbox.
#pragma once

#include "script/sandbox.h"

namespace strobe::script {

// In the registry of a state: the environment of scripts, what `require` has loaded.
inline constexpr const char *kEnvironment = "strobe.environment", *kLoaded = "strobe.loaded";

// That of a state.
inline Sandbox& self(lua_State* lua) { return **static_cast<Sandbox**>(lua_getextraspace(lua)); }

struct Sandbox::Callbacks {
  struct Native;
  static const luaL_Reg* native();  // the functions of the module strobe.native
  // Keeps the text in `source_` as a function of the registry: `ready_chunk_`.
  static int keepChunk(lua_State* lua);
  // The error as it is, or with the place of the user's line in front where it arose in the library.
  static int message(lua_State* lua);
};

}  // namespace strobe::script
