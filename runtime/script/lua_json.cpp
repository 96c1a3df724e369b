// SPDX-License-Identifier: MIT
#include "script/lua_json.h"

#include <cmath>
#include <map>

#include "base/error.h"

namespace strobe::script {

static constexpr int kDepth = 64;

void pushJson(lua_State* lua, const Json& json) {
  luaL_checkstack(lua, 4, "data nested too deeply");
  if (json.is_boolean()) return lua_pushboolean(lua, json.get<bool>());
  if (json.is_number_integer()) return lua_pushinteger(lua, json.get<int64_t>());
  if (json.is_number_float()) return lua_pushnumber(lua, json.get<double>());
  if (json.is_string()) {
    const auto& text = json.get_ref<const std::string&>();
    lua_pushlstring(lua, text.data(), text.size());
    return;
  }
  if (!json.is_structured()) return lua_pushnil(lua);

  lua_newtable(lua);
  lua_Integer count = 0;
  if (json.is_array()) {
    for (const Json& item : json) pushJson(lua, item), lua_rawseti(lua, -2, ++count);
    return;
  }
  for (const auto& [key, value] : json.items()) pushJson(lua, value), lua_setfield(lua, -2, key.c_str());
}

static Json valueAt(lua_State* lua, int index, const std::string& path, int depth);

[[noreturn]] static void refuse(const std::string& path, const std::string& what) {
  throw Error(fmt::format("{} {}", path.empty() ? "the result" : "'" + path + "'", what));
}

static Json arrayAt(lua_State* lua, int index, const std::string& path, int depth) {
  Json array = Json::array();
  lua_Integer count = static_cast<lua_Integer>(lua_rawlen(lua, index));
  for (lua_Integer i = 1; i <= count; ++i) {
    lua_rawgeti(lua, index, i);
    array.push_back(valueAt(lua, lua_gettop(lua), fmt::format("{}[{}]", path, i), depth + 1));
    lua_pop(lua, 1);
  }
  return array;
}

// The keys first: text of the key to its value, which sorts them.
static Json objectAt(lua_State* lua, int index, const std::string& path, int depth) {
  std::map<std::string, Json> fields;
  for (lua_pushnil(lua); lua_next(lua, index); lua_pop(lua, 1)) {
    if (lua_type(lua, -2) != LUA_TSTRING) refuse(path, "has keys that are neither names nor 1, 2, 3 ...");
    size_t size = 0;
    const char* key = lua_tolstring(lua, -2, &size);
    std::string name(key, size);
    fields[name] = valueAt(lua, lua_gettop(lua), path.empty() ? name : path + "." + name, depth + 1);
  }
  Json object = Json::object();
  for (auto& [key, value] : fields) object[key] = std::move(value);
  return object;
}

static bool isList(lua_State* lua, int index) {
  size_t entries = 0;
  for (lua_pushnil(lua); lua_next(lua, index); lua_pop(lua, 1)) ++entries;
  return entries == lua_rawlen(lua, index);
}

static Json valueAt(lua_State* lua, int index, const std::string& path, int depth) {
  if (depth > kDepth || !lua_checkstack(lua, 4)) refuse(path, "is nested too deeply; does a table contain itself?");
  switch (lua_type(lua, index)) {
    case LUA_TNIL:
      return nullptr;
    case LUA_TBOOLEAN:
      return lua_toboolean(lua, index) != 0;
    case LUA_TSTRING: {
      size_t size = 0;
      const char* text = lua_tolstring(lua, index, &size);
      return std::string(text, size);
    }
    case LUA_TNUMBER: {
      if (lua_isinteger(lua, index)) return static_cast<int64_t>(lua_tointeger(lua, index));
      double number = lua_tonumber(lua, index);
      if (!std::isfinite(number)) refuse(path, "is not a finite number");
      return number + 0.0;  // no negative zero
    }
    case LUA_TTABLE:
      return isList(lua, index) ? arrayAt(lua, index, path, depth) : objectAt(lua, index, path, depth);
    default:
      refuse(path, fmt::format("is a {}, not plain data", lua_typename(lua, lua_type(lua, index))));
  }
}

Json jsonAt(lua_State* lua, int index) { return valueAt(lua, lua_absindex(lua, index), "", 0); }

}  // namespace strobe::script
