// SPDX-License-Identifier: MIT
#include "script/sandbox.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "base/hash.h"
#include "plan/facts.h"
#include "script/locate.h"
#include "script/lua_json.h"
#include "script/ordered_pairs.h"
#include "script/prelude.lua.h"

namespace strobe::script {

namespace fs = std::filesystem;

static constexpr const char* kEnvironment = "strobe.environment";
static constexpr const char* kLoaded = "strobe.loaded";
static constexpr int kMaxPath = 12;

static Sandbox& self(lua_State* lua) { return **static_cast<Sandbox**>(lua_getextraspace(lua)); }

// What C++ throws inside a callback becomes a text; the caller then raises it as a Lua error.
bool Sandbox::guarded(const std::function<void()>& work) {
  try {
    work();
    return true;
  } catch (const std::exception& error) {
    text_ = error.what();
  } catch (...) {
    text_ = "unknown failure";
  }
  return false;
}

// ---- places

// Fills `ar` with the nearest Lua function from `level` up that is not of the library.
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

// `otherwise` is the file to name where no line of the user's is running.
static void pushUserPlace(lua_State* lua, int level, const char* otherwise) {
  lua_Debug ar;
  bool found = userFrame(lua, level, ar);
  pushPlace(lua, found ? ar.source + 1 : otherwise, found ? ar.currentline : 0);
}

// ---- what Lua calls

struct Sandbox::Callbacks {
  // native.at_caller(f): a function that calls f(place, ...), `place` being the line that called it. As a C function
  // it keeps that line even where it is the last call of a `return`.
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

  // caller_place(level): 1 is the function that asks, 2 its caller. Frames of C and of the library are skipped; a
  // caller that ended in `return f()` is gone, so constructors are better made with `native.at_caller`.
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

  // native.return_place(function, key...): the place of a field of the table that a function returns last.
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

  // native.reads_field(name): whether a file of the user's reads a field `name` of anything, run or not.
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

  // native.has_other_keys(t, names): whether a table has a key that is not in a list.
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

  // native.check_value(parameter, value): the value in canonical form, or nil and what is wrong.
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
    static const std::map<std::string, plan::ParamDesc::Type> types = {{"bool", plan::ParamDesc::Type::Bool},
                                                                       {"int", plan::ParamDesc::Type::Int},
                                                                       {"float", plan::ParamDesc::Type::Float},
                                                                       {"choice", plan::ParamDesc::Type::Choice}};
    plan::ParamDesc param;
    auto text = [&](const char* name) {
      Json value = field(name);
      return value.is_string() ? value.get<std::string>() : std::string();
    };
    param.name = text("name");
    param.type = types.at(text("type"));
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

  static int formats(lua_State* lua) { return pushNames(lua, plan::formatNames()); }

  static int facts(lua_State* lua) { return pushNames(lua, plan::factNames()); }

  static int invariants(lua_State* lua) { return pushNames(lua, plan::invariantNames()); }

  static int roles(lua_State* lua) { return pushNames(lua, plan::roleNames()); }

  static int pipelineKinds(lua_State* lua) { return pushNames(lua, plan::pipelineKindNames()); }

  static int write(lua_State* lua) {
    size_t size = 0;
    const char* text = luaL_checklstring(lua, 1, &size);
    std::fwrite(text, 1, size, stderr);
    return 0;
  }

  // Pushes the text in `source_` as a function of the sandbox's environment, named `chunk_`.
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

    // By file as well: one file has one result under all its names. `false` stands for a file that is being run.
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
    lua_pushvalue(lua, 3);
    lua_pushvalue(lua, -2);
    lua_rawset(lua, 2);
    lua_pushvalue(lua, -1);
    lua_setfield(lua, 2, name);
    return 1;
  }

  // Notes in the table at 2 that the chunk named at 3 is running, or not any more.
  static void remember(lua_State* lua, bool ended) {
    lua_pushvalue(lua, 3);
    if (ended) lua_pushnil(lua);
    if (!ended) lua_pushboolean(lua, 0);
    lua_rawset(lua, 2);
  }

  // native.files(folder): names of the Lua files in a folder of the home folder, sorted. Which there are decides the
  // result, so the folder is a dependency.
  static int files(lua_State* lua) {
    const char* folder = luaL_checkstring(lua, 1);
    Sandbox& sandbox = self(lua);
    if (!sandbox.guarded([&] { sandbox.list(folder); })) return lua_error(pushText(lua, sandbox.text_));
    lua_newtable(lua);
    for (size_t i = 0; i < sandbox.names_.size(); ++i) {
      lua_pushlstring(lua, sandbox.names_[i].data(), sandbox.names_[i].size());
      lua_rawseti(lua, -2, lua_Integer(i) + 1);
    }
    return 1;
  }

  static lua_State* pushText(lua_State* lua, const std::string& text) {
    lua_pushlstring(lua, text.data(), text.size());
    return lua;
  }

  // Pushes the file as a function.
  static void loadFile(lua_State* lua, const Path& file, const std::string& shown) {
    Sandbox& sandbox = self(lua);
    if (!sandbox.guarded([&] { sandbox.read(file, shown); })) {
      lua_pushlstring(lua, sandbox.text_.data(), sandbox.text_.size());
      lua_error(lua);
    }
    loadChunk(lua);
  }

  // Keeps the text in `source_` as a function of the registry: `ready_chunk_`.
  static int keepChunk(lua_State* lua) {
    loadChunk(lua);
    self(lua).ready_chunk_ = luaL_ref(lua, LUA_REGISTRYINDEX);
    return 0;
  }

  // native.preset(): runs the file of the preset that was asked for; true, what it returns, and how errors name it, or
  // false where there is no such file.
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

  // native.main(...): runs the file that was asked for.
  static int main(lua_State* lua) {
    Sandbox& sandbox = self(lua);
    loadFile(lua, sandbox.task_.main, sandbox.task_.shown);
    lua_insert(lua, 1);
    lua_call(lua, lua_gettop(lua) - 1, 1);
    return 1;
  }

  // The error as it is, or with the place of the user's line in front where it arose in the library.
  static int message(lua_State* lua) {
    if (lua_type(lua, 1) != LUA_TSTRING) return 1;
    std::string_view text = lua_tostring(lua, 1);
    bool placed_in_library = self(lua).isLibrary(text) || text.starts_with("[strobe]:");
    lua_Debug ar;
    if (!placed_in_library || !userFrame(lua, 1, ar)) return 1;
    lua_pushfstring(lua, "%s:%d: %s", ar.source + 1, ar.currentline, lua_tostring(lua, 1));
    return 1;
  }
};

// ---- modules

static bool isModuleName(const std::string& name) {
  const char* allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";
  bool plain = !name.empty() && name.find_first_not_of(allowed) == std::string::npos;
  return plain && name.front() != '.' && name.back() != '.' && name.find("..") == std::string::npos;
}

void Sandbox::readAhead(const Path& file, const std::string& shown) {
  Ahead ahead;
  ahead.stamps.add(file);
  ready_chunk_ = 0;
  chunk_ = "@" + shown;
  if (!guarded([&] { source_ = home_.read(file); })) return;
  lua_settop(lua_, 0);
  lua_pushcfunction(lua_, Callbacks::keepChunk);
  if (lua_pcall(lua_, 0, 0, 0) != LUA_OK) return;
  std::map<std::string, Source> sources;
  sources.try_emplace(shown, source_).first->second.prepare();
  ahead.shown = shown, ahead.text = source_, ahead.hash = hashText(source_);
  ahead.chunk = ready_chunk_;
  ahead.source = sources.extract(shown);
  ahead_[file.string()] = std::move(ahead);
}

// What was read ahead of a file, where the file, or what stands in its place, says that still; or null.
Sandbox::Ahead* Sandbox::stillAhead(const Path& file) {
  auto found = ahead_.find(file.string());
  if (found == ahead_.end()) return nullptr;
  auto given = task_.texts.find(found->first);
  Ahead& ahead = found->second;
  return (given == task_.texts.end() ? ahead.stamps.current() : given->second == ahead.text) ? &ahead : nullptr;
}

void Sandbox::take(const Path& file, Ahead& ahead) {
  chunk_ = "@" + ahead.shown;
  source_ = ahead.text;
  ready_chunk_ = ahead.chunk;
  if (!ahead.source) return;
  sources_.insert(std::move(ahead.source));
  files_.push_back({file, ahead.shown, ahead.hash});
}

// A file of the home folder that was found where it is when it was read ahead. Looking for it in each root, and whether
// links lead out of them, takes longer than running most modules.
bool Sandbox::takeAhead(const Path& relative) {
  for (const Path& place : home_.places(relative)) {
    if (Ahead* ahead = stillAhead(place)) return take(place, *ahead), true;
    if (isThere(place)) return false;
  }
  return false;
}

void Sandbox::read(const Path& file, const std::string& shown) {
  Ahead* ahead = stillAhead(file);
  if (ahead && ahead->shown == shown) return take(file, *ahead);
  chunk_ = "@" + shown;
  ready_chunk_ = 0;
  auto given = task_.texts.find(file.string());
  source_ = given == task_.texts.end() ? home_.read(file) : given->second;
  if (!sources_.try_emplace(shown, source_).second) return;
  files_.push_back({file, shown, hashText(source_)});
}

void Sandbox::list(const std::string& folder) {
  if (folder.find("..") != std::string::npos || home_.folders(folder).empty())
    throw Error(fmt::format("there is no folder '{}'", folder));
  names_ = home_.namesIn(folder, ".lua");
  // A folder that a project may get is a dependency as well.
  for (const Path& path : home_.places(folder)) {
    auto listed = std::find_if(files_.begin(), files_.end(), [&](const Dependency& file) { return file.path == path; });
    if (listed == files_.end()) files_.push_back({path, home_.shown(path), hashOfPath(path)});
  }
}

bool Sandbox::liesInHome(const Path& file) const {
  const auto& roots = home_.roots();
  return std::any_of(roots.begin(), roots.end(), [&](const Path& root) { return liesIn(file, root); });
}

bool Sandbox::isThere(const Path& file) const { return task_.texts.count(file.string()) || fs::is_regular_file(file); }

// Where `require` looks: the library, passes and scripts of the home folder, then the folder of the user's own file.
void Sandbox::resolve(const std::string& module) {
  if (!isModuleName(module)) {
    throw Error(fmt::format("'{}' is not the name of a module (words joined by dots)", module));
  }
  std::string relative = module;
  std::replace(relative.begin(), relative.end(), '.', '/');
  relative += ".lua";
  std::string root = module.substr(0, module.find('.'));
  if (root == "strobe") relative = "scripts/" + relative;

  bool in_home = root == "strobe" || root == "passes" || root == "scripts";
  if (in_home && takeAhead(relative)) return;
  Path file = home_.at(relative);
  if (in_home && isThere(file)) return read(file, home_.shown(file));
  Path own = task_.main.parent_path() / relative;
  if (task_.own_folder && isThere(own)) {
    if (!liesIn(own, task_.main.parent_path()) && !liesInHome(own))
      throw Error(fmt::format("module '{}' is a link that leads out of its folder", module));
    Path shown = Path(task_.shown).parent_path() / relative;
    return read(own, shown.string());
  }
  std::string near = didYouMean(module, moduleNames());
  if (!in_home && near.empty()) near = "; modules begin with passes., scripts. or strobe.";
  throw Error(fmt::format("there is no module '{}'{}", module, near));
}

std::vector<std::string> Sandbox::moduleNames() const {
  std::vector<std::string> names;
  auto add = [&](const std::string& folder, const std::string& prefix) {
    for (std::string name : home_.namesBelow(folder, ".lua")) {
      std::replace(name.begin(), name.end(), '/', '.');
      names.push_back(prefix + name);
    }
  };
  add("passes", "passes.");
  add("scripts/strobe", "strobe.");
  add("scripts", "scripts.");
  std::sort(names.begin(), names.end());
  return names;
}

// ---- the state

void* Sandbox::allocate(void* data, void* block, size_t old_size, size_t new_size) {
  auto& sandbox = *static_cast<Sandbox*>(data);
  size_t freed = block ? old_size : 0;
  if (new_size == 0) {
    sandbox.used_bytes_ -= freed;
    std::free(block);
    return nullptr;
  }
  size_t wanted = sandbox.used_bytes_ - freed + new_size;
  void* grown = wanted <= sandbox.memory_bytes_ ? std::realloc(block, new_size) : nullptr;
  if (grown) sandbox.used_bytes_ = wanted;
  return grown;
}

Sandbox::Sandbox(Home home, size_t memory_bytes)
    : home_(std::move(home)),
      memory_bytes_(memory_bytes),
      library_(home_.shown(home_.shipped() / "scripts/strobe") + "/") {
  lua_ = lua_newstate(allocate, this);
  STROBE_ASSERT(lua_ != nullptr);
  *static_cast<Sandbox**>(lua_getextraspace(lua_)) = this;
  // Garbage is collected at the limit of memory alone: marking what lives would copy its pages in a forked process, and
  // no finalizer of a script runs at a time of its own.
  lua_gc(lua_, LUA_GCSTOP);
  openLibraries();
  loadPrelude();
}

void Sandbox::openLibraries() {
  static const luaL_Reg libraries[] = {{LUA_GNAME, luaopen_base},
                                       {LUA_TABLIBNAME, luaopen_table},
                                       {LUA_STRLIBNAME, luaopen_string},
                                       {LUA_MATHLIBNAME, luaopen_math},
                                       {LUA_UTF8LIBNAME, luaopen_utf8}};
  for (const luaL_Reg& library : libraries) {
    luaL_requiref(lua_, library.name, library.func, 1);
    lua_pop(lua_, 1);
  }
}

void Sandbox::loadPrelude() {
  static const luaL_Reg functions[] = {{"at_caller", Callbacks::atCaller},
                                       {"caller_place", Callbacks::callerPlace},
                                       {"key_place", Callbacks::keyPlace},
                                       {"return_place", Callbacks::returnPlace},
                                       {"reads_field", Callbacks::readsFieldAnywhere},
                                       {"has_other_keys", Callbacks::hasOtherKeys},
                                       {"pairs", orderedPairs},
                                       {"next", firstPair},
                                       {"nearest", Callbacks::nearest},
                                       {"check_value", Callbacks::checkValue},
                                       {"formats", Callbacks::formats},
                                       {"facts", Callbacks::facts},
                                       {"invariants", Callbacks::invariants},
                                       {"roles", Callbacks::roles},
                                       {"pipeline_kinds", Callbacks::pipelineKinds},
                                       {"files", Callbacks::files},
                                       {"write", Callbacks::write},
                                       {"require", Callbacks::require},
                                       {"main", Callbacks::main},
                                       {"preset", Callbacks::preset},
                                       {nullptr, nullptr}};
  lua_newtable(lua_);
  lua_newtable(lua_);
  luaL_setfuncs(lua_, functions, 0);
  lua_pushvalue(lua_, -1);
  lua_setfield(lua_, -3, "strobe.native");
  lua_insert(lua_, -2);
  lua_setfield(lua_, LUA_REGISTRYINDEX, kLoaded);

  bool loaded = luaL_loadbufferx(lua_, kPrelude, std::char_traits<char>::length(kPrelude), "=[strobe]", "t") == LUA_OK;
  STROBE_ASSERT(loaded, "{}", lua_tostring(lua_, -1));
  lua_insert(lua_, -2);
  bool ran = lua_pcall(lua_, 1, 1, 0) == LUA_OK;
  STROBE_ASSERT(ran, "{}", lua_tostring(lua_, -1));
  lua_setfield(lua_, LUA_REGISTRYINDEX, kEnvironment);
}

// Everything Lua does happens below this protected call.
static int protectedRun(lua_State* lua) {
  const Json& request = *static_cast<const Json*>(lua_touserdata(lua, 2));
  const char* function = luaL_checkstring(lua, 1);
  lua_getfield(lua, LUA_REGISTRYINDEX, kEnvironment);
  lua_getfield(lua, -1, "require");
  lua_pushstring(lua, "strobe.run");
  lua_call(lua, 1, 1);
  lua_getfield(lua, -1, function);
  pushJson(lua, request);
  lua_call(lua, 1, 1);
  return 1;
}

bool Sandbox::run(const std::string& function, const Json& request, Json& result) {
  lua_settop(lua_, 0);
  lua_pushcfunction(lua_, Callbacks::message);
  lua_pushcfunction(lua_, protectedRun);
  lua_pushstring(lua_, function.c_str());
  lua_pushlightuserdata(lua_, const_cast<Json*>(&request));
  int status = lua_pcall(lua_, 2, 1, 1);
  out_of_memory_ = status == LUA_ERRMEM;
  try {
    if (status == LUA_OK) result = jsonAt(lua_, -1);
    if (status != LUA_OK && !out_of_memory_) collectProblems();
  } catch (const Error& error) {
    addProblem(error.message());
  } catch (const Json::exception&) {
    addProblem("the error is a table of a wrong form");
  }
  return !out_of_memory_ && problems_.empty();
}

void Sandbox::prepareSources() const {
  for (const auto& [shown, source] : sources_) source.prepare();
}

// ---- errors

// An error is a text with a place in front, or a table { problems = { { place = , message = }, ... } }.
void Sandbox::collectProblems() {
  if (lua_type(lua_, -1) == LUA_TSTRING) return addProblem(lua_tostring(lua_, -1));
  if (lua_type(lua_, -1) != LUA_TTABLE) {
    return addProblem(fmt::format("the error is a {} instead of a text", luaL_typename(lua_, -1)));
  }
  Json error = jsonAt(lua_, -1);
  if (!error.is_object() || !error.contains("problems")) return addProblem("the error is a table instead of a text");
  for (const Json& problem : error["problems"]) {
    const Json& place = problem.at("place");
    Place where{place.at("file").get<std::string>(), place.at("line").get<int>()};
    problems_.push_back({where, problem.at("message").get<std::string>()});
  }
}

// Lua shortens file names in messages to 60 characters.
std::string Sandbox::withFullNames(const std::string& message) const {
  for (const auto& [shown, source] : sources_) {
    if (shown.size() < LUA_IDSIZE) continue;
    std::string tail = "..." + shown.substr(shown.size() - (LUA_IDSIZE - 4));
    if (message.starts_with(tail + ":")) return shown + message.substr(tail.size());
  }
  return message;
}

void Sandbox::addProblem(const std::string& raw) {
  std::string message = withFullNames(raw);
  for (const auto& [shown, source] : sources_) {
    if (!message.starts_with(shown + ":")) continue;
    size_t digits = shown.size() + 1;
    size_t end = message.find_first_not_of("0123456789", digits);
    if (end == digits || end == std::string::npos || message[end] != ':') continue;
    int line = std::atoi(message.c_str() + digits);
    std::string rest = message.substr(std::min(end + 2, message.size()));
    std::replace(rest.begin(), rest.end(), '\n', ' ');
    Problem problem{Place{shown, line}, rest};
    problems_.push_back(problem);
    return;
  }
  Problem problem{Place{task_.shown}, message};
  problems_.push_back(problem);
}

}  // namespace strobe::script
