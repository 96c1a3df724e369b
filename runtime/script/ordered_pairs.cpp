// SPDX-License-Identifier: MIT
#include "script/ordered_pairs.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace strobe::script {

namespace {

// A key of a table. The table owns the text.
struct TableKey {
  int type = LUA_TNIL;
  bool whole = false;
  lua_Integer integer = 0;  // 0 or 1 for a boolean
  lua_Number number = 0;
  std::string_view text;

  bool operator<(const TableKey& other) const {
    if (type != other.type) return type < other.type;
    if (type == LUA_TSTRING) return text < other.text;
    if (type == LUA_TBOOLEAN || (whole && other.whole)) return integer < other.integer;
    return asNumber() < other.asNumber();
  }
  long double asNumber() const { return whole ? static_cast<long double>(integer) : number; }  // exact
};

static_assert(LUA_TBOOLEAN < LUA_TNUMBER && LUA_TNUMBER < LUA_TSTRING);

// The key on top of the stack.
TableKey keyOnTop(lua_State* lua) {
  TableKey key{lua_type(lua, -1)};
  if (key.type == LUA_TBOOLEAN) {
    key.integer = lua_toboolean(lua, -1);
  } else if (key.type == LUA_TSTRING) {
    size_t size = 0;
    const char* text = lua_tolstring(lua, -1, &size);
    key.text = {text, size};
  } else if (key.type == LUA_TNUMBER) {
    key.whole = lua_isinteger(lua, -1);
    if (key.whole) key.integer = lua_tointeger(lua, -1);
    else key.number = lua_tonumber(lua, -1);
  } else {
    luaL_error(lua, "keys of type %s have no fixed order; keep a list beside the table", luaL_typename(lua, -1));
  }
  return key;
}

void push(lua_State* lua, const TableKey& key) {
  if (key.type == LUA_TBOOLEAN) lua_pushboolean(lua, int(key.integer));
  else if (key.type == LUA_TSTRING) lua_pushlstring(lua, key.text.data(), key.text.size());
  else if (key.whole) lua_pushinteger(lua, key.integer);
  else lua_pushnumber(lua, key.number);
}

// Buffer for sorting. It is kept per thread, because Lua's errors skip destructors.
std::vector<TableKey>& room() {
  thread_local std::vector<TableKey> keys;
  return keys;
}

bool enlarge(std::vector<TableKey>& keys) {
  try {
    keys.resize(2 * keys.size() + 16);
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

// Pushes the sorted list of the keys of the table at index 1.
void pushOrderedKeys(lua_State* lua) {
  std::vector<TableKey>& keys = room();
  size_t count = 0;
  for (lua_pushnil(lua); lua_next(lua, 1); ++count) {
    lua_pop(lua, 1);
    if (count == keys.size() && !enlarge(keys)) luaL_error(lua, "not enough memory");
    keys[count] = keyOnTop(lua);
  }
  std::sort(keys.begin(), keys.begin() + ptrdiff_t(count));
  lua_createtable(lua, int(count), 0);
  for (size_t i = 0; i < count; ++i) {
    push(lua, keys[i]);
    lua_rawseti(lua, -2, lua_Integer(i) + 1);
  }
}

// Iterator. Upvalues: the list of keys, the table, and the index of the last key returned.
int nextPair(lua_State* lua) {
  const int keys = lua_upvalueindex(1), table = lua_upvalueindex(2), last = lua_upvalueindex(3);
  for (lua_Integer i = lua_tointeger(lua, last) + 1; lua_rawgeti(lua, keys, i) != LUA_TNIL; ++i) {
    lua_pushvalue(lua, -1);
    if (lua_rawget(lua, table) != LUA_TNIL) {
      lua_pushinteger(lua, i);
      lua_replace(lua, last);
      return 2;
    }
    lua_pop(lua, 2);
  }
  return 1;
}

}  // namespace

int orderedPairs(lua_State* lua) {
  if (luaL_getmetafield(lua, 1, "__pairs") != LUA_TNIL) {
    lua_pushvalue(lua, 1);
    lua_call(lua, 1, 3);
    return 3;
  }
  if (lua_type(lua, 1) != LUA_TTABLE) return luaL_error(lua, "pairs needs a table, got %s", luaL_typename(lua, 1));
  pushOrderedKeys(lua);
  lua_pushvalue(lua, 1);
  lua_pushinteger(lua, 0);
  lua_pushcclosure(lua, nextPair, 3);
  lua_pushvalue(lua, 1);
  lua_pushnil(lua);
  return 3;
}

int firstPair(lua_State* lua) {
  if (lua_type(lua, 1) != LUA_TTABLE) return luaL_error(lua, "next needs a table, got %s", luaL_typename(lua, 1));
  if (!lua_isnoneornil(lua, 2))
    return luaL_error(lua, "next only tests whether a table is empty; use pairs to iterate over a table");
  pushOrderedKeys(lua);
  if (lua_rawgeti(lua, -1, 1) == LUA_TNIL) return 1;
  lua_pushvalue(lua, -1);
  lua_rawget(lua, 1);
  return 2;
}

}  // namespace strobe::script
