// SPDX-License-Identifier: MIT
#include "script/lua_json.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/json.h"

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

namespace {

// Path to a value, for errors: a list of keys from the innermost to the outermost.
struct Way {
  const Way* outer = nullptr;
  const char* key = nullptr;  // null: entry number `place` of a list
  lua_Integer place = 0;
  int depth = 0;

  std::string text() const {
    std::string before = outer ? outer->text() : "";
    if (depth == 0) return before;
    if (!key) return fmt::format("{}[{}]", before, place);
    return before.empty() ? key : before + "." + key;
  }
};

Json valueAt(lua_State* lua, int index, const Way& way);

[[noreturn]] void refuse(const Way& way, const std::string& what) {
  const std::string path = way.text();
  throw Error(fmt::format("{} {}", path.empty() ? "the result" : "'" + path + "'", what));
}

Json arrayAt(lua_State* lua, int index, const Way& way) {
  Json array = Json::array();
  lua_Integer count = static_cast<lua_Integer>(lua_rawlen(lua, index));
  for (lua_Integer i = 1; i <= count; ++i) {
    lua_rawgeti(lua, index, i);
    array.push_back(valueAt(lua, lua_gettop(lua), {&way, nullptr, i, way.depth + 1}));
    lua_pop(lua, 1);
  }
  return array;
}

// Object with sorted keys, independent of the order in the table.
Json objectAt(lua_State* lua, int index, const Way& way) {
  std::vector<std::pair<std::string, Json>> fields;
  for (lua_pushnil(lua); lua_next(lua, index); lua_pop(lua, 1)) {
    if (lua_type(lua, -2) != LUA_TSTRING) refuse(way, "has keys that are neither names nor 1, 2, 3 ...");
    size_t size = 0;
    const char* key = lua_tolstring(lua, -2, &size);
    fields.emplace_back(std::string(key, size), valueAt(lua, lua_gettop(lua), {&way, key, 0, way.depth + 1}));
  }
  std::sort(fields.begin(), fields.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  Json object = Json::object();
  auto& entries = object.get_ref<Json::object_t&>();
  entries.reserve(fields.size());
  for (auto& [key, value] : fields) entries.push_back({key, std::move(value)});
  return object;
}

bool isList(lua_State* lua, int index) {
  size_t entries = 0;
  for (lua_pushnil(lua); lua_next(lua, index); lua_pop(lua, 1)) ++entries;
  return entries == lua_rawlen(lua, index);
}

Json valueAt(lua_State* lua, int index, const Way& way) {
  if (way.depth > kDepth || !lua_checkstack(lua, 4)) refuse(way, "is nested too deeply; does a table contain itself?");
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
      if (!std::isfinite(number)) refuse(way, "is not a finite number");
      return number + 0.0;  // no negative zero
    }
    case LUA_TTABLE:
      return isList(lua, index) ? arrayAt(lua, index, way) : objectAt(lua, index, way);
    default:
      refuse(way, fmt::format("is a {}, not plain data", lua_typename(lua, lua_type(lua, index))));
  }
}

}  // namespace

Json jsonAt(lua_State* lua, int index) { return valueAt(lua, lua_absindex(lua, index), {}); }

}  // namespace strobe::script
