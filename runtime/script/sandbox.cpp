// SPDX-License-Identifier: MIT
#include "script/sandbox.h"

#include <algorithm>
#include <cstdlib>

#include "base/hash.h"
#include "script/callbacks.h"
#include "script/locate.h"
#include "script/lua_json.h"
#include "script/prelude.lua.h"

namespace strobe::script {

namespace fs = std::filesystem;

// Runs `work`. A C++ exception is stored in `text_`, and the caller raises the text as a Lua error.
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

// ---- modules

static bool isModuleName(const std::string& name) {
  const char* allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";
  bool plain = !name.empty() && name.find_first_not_of(allowed) == std::string::npos;
  return plain && name.front() != '.' && name.back() != '.' && name.find("..") == std::string::npos;
}

void Sandbox::compileAhead(const Path& file, const std::string& shown) {
  if (stillAhead(file)) return;
  const auto outdated = ahead_.extract(file.string());
  if (outdated) luaL_unref(lua_, LUA_REGISTRYINDEX, outdated.mapped().chunk);
  if (outdated) lua_gc(lua_, LUA_GCCOLLECT);
  Ahead ahead{shown, {}, {}};
  ahead.stamps.add(file);
  ready_chunk_ = 0;
  chunk_ = "@" + shown;
  if (!guarded([&] { source_ = home_.read(file); })) return;
  lua_settop(lua_, 0);
  lua_pushcfunction(lua_, Callbacks::keepChunk);
  if (lua_pcall(lua_, 0, 0, 0) != LUA_OK) return;
  std::map<std::string, LuaSource> sources;
  sources.try_emplace(shown, source_).first->second.prepare();
  ahead.text = source_, ahead.hash = hashText(source_);
  ahead.chunk = ready_chunk_;
  ahead.source = sources.extract(shown);
  ahead_.emplace(file.string(), std::move(ahead));
}

// The compiled data of a file, or null if the file or its replacement text has changed since.
Sandbox::Ahead* Sandbox::stillAhead(const Path& file) {
  auto found = ahead_.find(file.string());
  if (found == ahead_.end()) return nullptr;
  auto given = task_.texts.find(found->first);
  Ahead& ahead = found->second;
  return (given == task_.texts.end() ? ahead.stamps.current() : given->second == ahead.text) ? &ahead : nullptr;
}

void Sandbox::noteState(const Path& file) {
  stamps_.add(file);
  const Path folder = file.parent_path();
  if (!folders_.insert(folder).second) return;
  stamps_.add(folder);
  const std::optional<std::string> name = home_.nameOf(file);
  for (const Path& place : name ? home_.places(Path(*name).parent_path()) : std::vector<Path>()) stamps_.add(place);
}

void Sandbox::take(const Path& file, Ahead& ahead) {
  noteState(file);
  chunk_ = "@" + ahead.shown;
  source_ = ahead.text;
  ready_chunk_ = ahead.chunk;
  if (!ahead.source) return;
  sources_.insert(std::move(ahead.source));
  files_.push_back({file, ahead.shown, ahead.hash});
}

// Takes a file of the home folder that was compiled ahead, if it is still the first match in the roots. Searching each
// root, and checking that links stay inside the roots, takes longer than running most modules.
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
  noteState(file);
  chunk_ = "@" + shown;
  ready_chunk_ = 0;
  auto given = task_.texts.find(file.string());
  source_ = given == task_.texts.end() ? home_.read(file) : given->second;
  if (!sources_.try_emplace(shown, source_).second) return;
  files_.push_back({file, shown, hashText(source_)});
}

void Sandbox::list(const std::string& folder) {
  if (folder.find("..") != std::string::npos || home_.folders(folder).empty())
    throw Error(fmt::format("unknown folder '{}'", folder));
  names_ = home_.namesIn(folder, ".lua");
  // Folders that do not exist yet are dependencies too, because a project may add them.
  for (const Path& path : home_.places(folder)) {
    auto listed = std::find_if(files_.begin(), files_.end(), [&](const Dependency& file) { return file.path == path; });
    stamps_.add(path);
    if (listed == files_.end()) files_.push_back({path, home_.shown(path), hashOfPath(path)});
  }
}

static bool liesInHome(const Home& home, const Path& file) {
  const auto& roots = home.roots();
  return std::any_of(roots.begin(), roots.end(), [&](const Path& root) { return liesIn(file, root); });
}

bool Sandbox::isThere(const Path& file) const { return task_.texts.count(file.string()) || fs::is_regular_file(file); }

// Search order of `require`: the library, passes and scripts of the home folder, then the folder of the user's file.
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
    if (!liesIn(own, task_.main.parent_path()) && !liesInHome(home_, own))
      throw Error(fmt::format("module '{}' is a link that leads out of its folder", module));
    Path shown = Path(task_.shown).parent_path() / relative;
    return read(own, shown.string());
  }
  std::string near = didYouMean(module, moduleNames());
  if (!in_home && near.empty()) near = "; modules begin with passes., scripts. or strobe.";
  throw Error(fmt::format("unknown module '{}'{}", module, near));
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
  void* grown = wanted <= sandbox.task_.memory_bytes ? std::realloc(block, new_size) : nullptr;
  if (grown) sandbox.used_bytes_ = wanted;
  return grown;
}

Sandbox::Sandbox(Home home) : home_(std::move(home)), library_(home_.shown(home_.shipped() / "scripts/strobe") + "/") {
  lua_ = lua_newstate(allocate, this);
  STROBE_ASSERT(lua_ != nullptr);
  *static_cast<Sandbox**>(lua_getextraspace(lua_)) = this;
  // Garbage is collected only at the memory limit. Marking live objects would copy their pages in a forked process, and
  // finalizers of a script would run at unpredictable times.
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
  lua_newtable(lua_);
  lua_newtable(lua_);
  luaL_setfuncs(lua_, Callbacks::native(), 0);
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

// All Lua code runs below this protected call.
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
    addProblem("the error is a table with a wrong form");
  }
  return !out_of_memory_ && problems_.empty();
}

void Sandbox::prepareSources() const {
  for (const auto& [shown, source] : sources_) source.prepare();
}

// ---- errors

// Reads an error: a text that begins with a place, or a table { problems = { { place = , message = }, ... } }.
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
