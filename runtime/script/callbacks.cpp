// SPDX-License-Identifier: MIT
#include "script/callbacks.h"

#include <algorithm>
#include <cstdio>

#include "plan/facts.h"
#include "plan/formats.h"
#include "plan/named.h"
#include "script/lua_json.h"
#include "script/ordered_pairs.h"

namespace strobe::script {

static constexpr int kMaxPath = 12;  // maximum number of keys in a path

// ---- places

// Fills `ar` with the nearest Lua function outside of the library, from `level` up the stack. False if none is found.
static bool userFrame(lua_State* lua, int level, lua_Debug& ar) {
  for (; lua_getstack(lua, level, &ar); ++level) {
    lua_getinfo(lua, "Sl", &ar);
    std::string_view source = ar.source;
    if (ar.currentline > 0 && source.starts_with("@") && !self(lua).isLibrary(source.substr(1))) return true;
  }
  return false;
}

Place Sandbox::userPlace(lua_State* lua, int level) {
  lua_Debug ar;
  if (!userFrame(lua, level, ar)) return {};
  return {ar.source + 1, ar.currentline};
}

static void pushPlace(lua_State* lua, const char* file, int line) {
  lua_createtable(lua, 0, 2);
  lua_pushstring(lua, file);
  lua_setfield(lua, -2, "file");
  lua_pushinteger(lua, line);
  lua_setfield(lua, -2, "line");
}

// `otherwise` is the file of the place if no user's line is running.
static void pushUserPlace(lua_State* lua, int level, const char* otherwise) {
  lua_Debug ar;
  bool found = userFrame(lua, level, ar);
  pushPlace(lua, found ? ar.source + 1 : otherwise, found ? ar.currentline : 0);
}

// ---- functions for Lua

struct Sandbox::Callbacks::Native {
  // native.at_caller(f): a function that calls f(place, ...), where `place` is the line of the call. This is a C
  // function, so the line is known even for a tail call (`return f()`).
  static int callWithPlace(lua_State* lua) {
    lua_pushvalue(lua, lua_upvalueindex(1));
    lua_insert(lua, 1);
    pushUserPlace(lua, 1, self(lua).task_.shown.c_str());
    lua_insert(lua, 2);
    lua_call(lua, lua_gettop(lua) - 1, LUA_MULTRET);
    return lua_gettop(lua);
  }

  static int atCaller(lua_State* lua) {
    luaL_checktype(lua, 1, LUA_TFUNCTION);
    lua_settop(lua, 1);
    lua_pushcclosure(lua, callWithPlace, 1);
    return 1;
  }

  // caller_place(level): 1 is the calling function, 2 its caller. Frames of C and of the library are skipped. A caller
  // that ended in `return f()` has no frame any more, so `native.at_caller` is better for constructors.
  static int callerPlace(lua_State* lua) {
    pushUserPlace(lua, static_cast<int>(luaL_optinteger(lua, 1, 1)), self(lua).task_.shown.c_str());
    return 1;
  }

  // native.key_place(place, key...): the place of a field of the table written at `place`.
  static int keyPlace(lua_State* lua) {
    const char* keys[kMaxPath];
    int count = std::min(lua_gettop(lua) - 1, kMaxPath);
    for (int i = 0; i < count; ++i) keys[i] = luaL_tolstring(lua, i + 2, nullptr);
    lua_getfield(lua, 1, "file");
    lua_getfield(lua, 1, "line");
    const char* file = luaL_checkstring(lua, -2);
    int line = static_cast<int>(luaL_checkinteger(lua, -1));
    Sandbox& sandbox = self(lua);
    sandbox.guarded([&] {
      auto source = sandbox.sources_.find(file);
      std::vector<std::string> path(keys, keys + count);
      if (source != sandbox.sources_.end()) line = source->second.lineOfKey(line, path);
    });
    pushPlace(lua, file, line);
    return 1;
  }

  // native.return_place(function, key...): the place of a field in the table of the last `return` of a function.
  static int returnPlace(lua_State* lua) {
    const char* keys[kMaxPath];
    int count = std::min(lua_gettop(lua) - 1, kMaxPath);
    for (int i = 0; i < count; ++i) keys[i] = luaL_tolstring(lua, i + 2, nullptr);
    luaL_checktype(lua, 1, LUA_TFUNCTION);
    lua_Debug ar;
    lua_pushvalue(lua, 1);
    lua_getinfo(lua, ">S", &ar);
    const char* file = *ar.source == '@' ? ar.source + 1 : "?";
    int line = ar.linedefined;
    Sandbox& sandbox = self(lua);
    sandbox.guarded([&] {
      auto source = sandbox.sources_.find(file);
      std::vector<std::string> path(keys, keys + count);
      if (source == sandbox.sources_.end()) return;
      int found = source->second.lineOfReturn(ar.linedefined, ar.lastlinedefined, path);
      if (found) line = found;
    });
    pushPlace(lua, file, line);
    return 1;
  }

  // native.reads_field(name): true if the user's files contain a read of a field `name` of any table, executed or not.
  static int readsFieldAnywhere(lua_State* lua) {
    const char* name = luaL_checkstring(lua, 1);
    bool found = false;
    Sandbox& sandbox = self(lua);
    sandbox.guarded([&] {
      for (const auto& [shown, source] : sandbox.sources_) {
        found = found || (!sandbox.isLibrary(shown) && source.readsField(name));
      }
    });
    lua_pushboolean(lua, found);
    return 1;
  }

  // native.conditions_on(name): places in the user's files that use `p.name` as a condition without calling it.
  static int conditionsOn(lua_State* lua) {
    const char* name = luaL_checkstring(lua, 1);
    std::vector<std::pair<std::string, int>> places;
    Sandbox& sandbox = self(lua);
    sandbox.guarded([&] {
      for (const auto& [shown, source] : sandbox.sources_)
        if (!sandbox.isLibrary(shown))
          for (int line : source.conditionsOn(name)) places.push_back({shown, line});
    });
    lua_createtable(lua, int(places.size()), 0);
    for (size_t i = 0; i < places.size(); ++i) {
      pushPlace(lua, places[i].first.c_str(), places[i].second);
      lua_rawseti(lua, -2, lua_Integer(i) + 1);
    }
    return 1;
  }

  // native.has_other_keys(t, names): true if the table has a key that is not in the list.
  static int hasOtherKeys(lua_State* lua) {
    luaL_checktype(lua, 1, LUA_TTABLE);
    luaL_checktype(lua, 2, LUA_TTABLE);
    const auto count = lua_Integer(lua_rawlen(lua, 2));
    for (lua_pushnil(lua); lua_next(lua, 1);) {
      lua_pop(lua, 1);
      bool found = false;
      for (lua_Integer i = 1; i <= count && !found; ++i) {
        lua_rawgeti(lua, 2, i);
        found = lua_rawequal(lua, -1, -2);
        lua_pop(lua, 1);
      }
      if (!found) return lua_pushboolean(lua, true), 1;
    }
    lua_pushboolean(lua, false);
    return 1;
  }

  // native.nearest(name, names): "; did you mean 'x'?" or "".
  static int nearest(lua_State* lua) {
    const char* name = luaL_tolstring(lua, 1, nullptr);
    luaL_checktype(lua, 2, LUA_TTABLE);
    Sandbox& sandbox = self(lua);
    sandbox.guarded([&] {
      std::vector<std::string> names;
      for (const Json& item : jsonAt(lua, 2)) {
        if (item.is_string()) names.push_back(item.get<std::string>());
      }
      sandbox.text_ = didYouMean(name, names);
    });
    lua_pushlstring(lua, sandbox.text_.data(), sandbox.text_.size());
    return 1;
  }

  // native.check_value(parameter, value): the value in canonical form, or nil and the error message.
  static int checkValue(lua_State* lua) {
    luaL_checktype(lua, 1, LUA_TTABLE);
    luaL_checkany(lua, 2);
    Sandbox& sandbox = self(lua);
    bool good = sandbox.guarded(
        [&] { sandbox.value_ = plan::checkValue(paramAt(lua, 1), plan::valueFromJson(jsonAt(lua, 2)), {}); });
    if (good) return pushValue(lua, sandbox.value_);
    lua_pushnil(lua);
    lua_pushlstring(lua, sandbox.text_.data(), sandbox.text_.size());
    return 2;
  }

  static int pushValue(lua_State* lua, const plan::Value& value) {
    if (auto* text = std::get_if<std::string>(&value)) lua_pushlstring(lua, text->data(), text->size());
    if (auto* flag = std::get_if<bool>(&value)) lua_pushboolean(lua, *flag);
    if (auto* whole = std::get_if<int64_t>(&value)) lua_pushinteger(lua, *whole);
    if (auto* number = std::get_if<double>(&value)) lua_pushnumber(lua, *number);
    return 1;
  }

  static plan::ParamDesc paramAt(lua_State* lua, int index) {
    auto field = [&](const char* name) {
      lua_getfield(lua, index, name);
      Json value = jsonAt(lua, -1);
      lua_pop(lua, 1);
      return value;
    };
    plan::ParamDesc param;
    auto text = [&](const char* name) {
      Json value = field(name);
      return value.is_string() ? value.get<std::string>() : std::string();
    };
    param.name = text("name");
    const auto& types = plan::kParamTypes;
    param.type = plan::ParamDesc::Type(std::find(types.begin(), types.end(), text("type")) - types.begin());
    if (Json min = field("min"); !min.is_null()) param.min = min.get<double>();
    if (Json max = field("max"); !max.is_null()) param.max = max.get<double>();
    if (Json choices = field("choices"); !choices.is_null()) param.choices = choices.get<std::vector<std::string>>();
    param.unit = text("unit");
    param.has_auto = field("auto") == true;
    return param;
  }

  static int pushNames(lua_State* lua, const std::vector<std::string>& names) {
    lua_newtable(lua);
    lua_Integer count = 0;
    for (const std::string& name : names) {
      lua_pushstring(lua, name.c_str());
      lua_rawseti(lua, -2, ++count);
    }
    return 1;
  }

  static int formats(lua_State* lua) { return pushNames(lua, plan::namesOf(plan::portFormats())); }

  static int facts(lua_State* lua) { return pushNames(lua, plan::namesOf(plan::facts())); }

  static int invariants(lua_State* lua) { return pushNames(lua, plan::invariantNames()); }

  static int roles(lua_State* lua) { return pushNames(lua, plan::roleNames()); }

  static int pipelineKinds(lua_State* lua) { return pushNames(lua, plan::pipelineKindNames()); }

  static int write(lua_State* lua) {
    size_t size = 0;
    const char* text = luaL_checklstring(lua, 1, &size);
    std::fwrite(text, 1, size, stderr);
    return 0;
  }

  // Pushes the text in `source_` as a function with the sandbox's environment and the name `chunk_`.
  static void loadChunk(lua_State* lua) {
    Sandbox& sandbox = self(lua);
    if (sandbox.ready_chunk_ != 0) {
      lua_rawgeti(lua, LUA_REGISTRYINDEX, sandbox.ready_chunk_);
      return;
    }
    if (luaL_loadbufferx(lua, sandbox.source_.data(), sandbox.source_.size(), sandbox.chunk_.c_str(), "t") != LUA_OK) {
      lua_error(lua);
    }
    lua_getfield(lua, LUA_REGISTRYINDEX, kEnvironment);
    lua_setupvalue(lua, -2, 1);
  }

  static void fail(lua_State* lua) {
    luaL_where(lua, 1);
    lua_pushlstring(lua, self(lua).text_.data(), self(lua).text_.size());
    lua_concat(lua, 2);
    lua_error(lua);
  }

  static int require(lua_State* lua) {
    const char* name = luaL_checkstring(lua, 1);
    Sandbox& sandbox = self(lua);
    lua_settop(lua, 1);
    lua_getfield(lua, LUA_REGISTRYINDEX, kLoaded);
    if (lua_getfield(lua, 2, name) != LUA_TNIL) return 1;
    lua_pop(lua, 1);
    if (!sandbox.guarded([&] { sandbox.resolve(name); })) fail(lua);

    // Results are also stored by file, so a file has one result under all its names. `false` marks a file that is
    // running.
    lua_pushstring(lua, sandbox.chunk_.c_str());
    lua_pushvalue(lua, 3);
    if (lua_rawget(lua, 2) == LUA_TBOOLEAN) luaL_error(lua, "module '%s' requires itself", name);
    if (!lua_isnil(lua, -1)) return 1;
    lua_settop(lua, 3);
    lua_pushcfunction(lua, message);
    loadChunk(lua);
    remember(lua, false);
    if (lua_pcall(lua, 0, 1, 4) != LUA_OK) {
      remember(lua, true);
      return lua_error(lua);
    }
    if (lua_isnil(lua, -1)) luaL_error(lua, "module '%s' returns nothing; it should end in 'return'", name);
    if (lua_isboolean(lua, -1)) luaL_error(lua, "module '%s' returns a boolean", name);
    close(lua, name);
    lua_pushvalue(lua, 3);
    lua_pushvalue(lua, -2);
    lua_rawset(lua, 2);
    lua_pushvalue(lua, -1);
    lua_setfield(lua, 2, name);
    return 1;
  }

  // __index of the table that a module returned. A missing name is an error at the line that reads it. The library may
  // read any name, because modules may return descriptions.
  static int unknownField(lua_State* lua) {
    if (lua_type(lua, 2) != LUA_TSTRING) return 0;  // entries of a list, including the index after the last entry
    lua_Debug reader;
    if (lua_getstack(lua, 1, &reader) && lua_getinfo(lua, "S", &reader) && *reader.source == '@' &&
        self(lua).isLibrary(reader.source + 1))
      return 0;
    const char* name = lua_tostring(lua, 2);
    const char* module = lua_tostring(lua, lua_upvalueindex(1));
    Sandbox& sandbox = self(lua);
    sandbox.guarded([&] {
      std::vector<std::string> names;
      for (lua_pushnil(lua); lua_next(lua, 1); lua_pop(lua, 1))
        if (lua_type(lua, -2) == LUA_TSTRING) names.emplace_back(lua_tostring(lua, -2));
      std::sort(names.begin(), names.end());
      sandbox.text_ = fmt::format("the module {} has no '{}'{}", module, name, didYouMean(name, names));
    });
    fail(lua);
    return 0;
  }

  // Closes the result of the module `name`, on top of the stack, if it is a table without a metatable.
  static void close(lua_State* lua, const char* name) {
    if (!lua_istable(lua, -1)) return;
    if (lua_getmetatable(lua, -1)) return lua_pop(lua, 1);
    lua_createtable(lua, 0, 1);
    lua_pushstring(lua, name);
    lua_pushcclosure(lua, unknownField, 1);
    lua_setfield(lua, -2, "__index");
    lua_setmetatable(lua, -2);
  }

  // Marks the chunk with the name at index 3 as running, in the table at index 2; `ended` removes the mark.
  static void remember(lua_State* lua, bool ended) {
    lua_pushvalue(lua, 3);
    if (ended) lua_pushnil(lua);
    if (!ended) lua_pushboolean(lua, 0);
    lua_rawset(lua, 2);
  }

  // native.files(folder): names of the Lua files in a folder of the home folder, sorted. The folder is a dependency,
  // because its list of files decides the result.
  static int files(lua_State* lua) {
    const char* folder = luaL_checkstring(lua, 1);
    Sandbox& sandbox = self(lua);
    if (!sandbox.guarded([&] { sandbox.list(folder); })) return lua_error(pushText(lua, sandbox.text_));
    return pushNames(lua, sandbox.names_);
  }

  static lua_State* pushText(lua_State* lua, const std::string& text) {
    lua_pushlstring(lua, text.data(), text.size());
    return lua;
  }

  // Reads a file and pushes it as a function.
  static void loadFile(lua_State* lua, const Path& file, const std::string& shown) {
    Sandbox& sandbox = self(lua);
    if (!sandbox.guarded([&] { sandbox.read(file, shown); })) lua_error(pushText(lua, sandbox.text_));
    loadChunk(lua);
  }

  // native.preset(): runs the file of the requested preset. Returns true, the result and the name of the file in
  // errors; or false if the file does not exist.
  static int preset(lua_State* lua) {
    Sandbox& sandbox = self(lua);
    bool there = false;
    sandbox.guarded([&] { there = sandbox.isThere(sandbox.task_.preset); });
    lua_pushboolean(lua, there);
    if (!there) return 1;
    loadFile(lua, sandbox.task_.preset, sandbox.task_.preset_shown);
    lua_call(lua, 0, 1);
    lua_pushstring(lua, sandbox.task_.preset_shown.c_str());
    return 3;
  }

  // native.main(...): runs the requested file.
  static int main(lua_State* lua) {
    Sandbox& sandbox = self(lua);
    loadFile(lua, sandbox.task_.main, sandbox.task_.shown);
    lua_insert(lua, 1);
    lua_call(lua, lua_gettop(lua) - 1, 1);
    return 1;
  }
};

const luaL_Reg* Sandbox::Callbacks::native() {
  static const luaL_Reg functions[] = {{"at_caller", Native::atCaller},
                                       {"caller_place", Native::callerPlace},
                                       {"key_place", Native::keyPlace},
                                       {"return_place", Native::returnPlace},
                                       {"reads_field", Native::readsFieldAnywhere},
                                       {"conditions_on", Native::conditionsOn},
                                       {"has_other_keys", Native::hasOtherKeys},
                                       {"pairs", orderedPairs},
                                       {"next", firstPair},
                                       {"nearest", Native::nearest},
                                       {"check_value", Native::checkValue},
                                       {"formats", Native::formats},
                                       {"facts", Native::facts},
                                       {"invariants", Native::invariants},
                                       {"roles", Native::roles},
                                       {"pipeline_kinds", Native::pipelineKinds},
                                       {"files", Native::files},
                                       {"write", Native::write},
                                       {"require", Native::require},
                                       {"main", Native::main},
                                       {"preset", Native::preset},
                                       {nullptr, nullptr}};
  return functions;
}

int Sandbox::Callbacks::keepChunk(lua_State* lua) {
  Native::loadChunk(lua);
  self(lua).ready_chunk_ = luaL_ref(lua, LUA_REGISTRYINDEX);
  return 0;
}

int Sandbox::Callbacks::message(lua_State* lua) {
  if (lua_type(lua, 1) != LUA_TSTRING) return 1;
  std::string_view text = lua_tostring(lua, 1);
  bool placed_in_library = self(lua).isLibrary(text) || text.starts_with("[strobe]:");
  lua_Debug ar;
  if (!placed_in_library || !userFrame(lua, 1, ar)) return 1;
  lua_pushfstring(lua, "%s:%d: %s", ar.source + 1, ar.currentline, lua_tostring(lua, 1));
  return 1;
}

}  // namespace strobe::script
