// SPDX-License-Identifier: MIT
// A fresh Lua state with a whitelisted environment: what a script child runs in.
//
// Lua raises errors by jumping over C++ frames, and C++ exceptions must not cross Lua's frames. So every callback
// takes its arguments first, does its C++ work inside `guarded`, which catches all, and raises a Lua error only from
// `text_`, a member, when nothing on its own frame needs a destructor.
#pragma once

#include <functional>
#include <lua.hpp>
#include <map>
#include <string>
#include <vector>

#include "base/home.h"
#include "base/json.h"
#include "script/evaluate.h"
#include "script/locate.h"

namespace strobe::script {

// One mistake, at the user's line.
struct Problem {
  Place place;
  std::string message;
};

class Sandbox {
 public:
  struct Options {
    Home home;
    Path main;                // the file that `native.main` runs
    std::string shown;        // how errors name it
    bool own_folder = false;  // its folder is searched by `require` too
    Path preset;              // the file that `native.preset` runs, or ""
    std::string preset_shown;
    size_t memory_bytes = size_t{256} << 20;
    std::map<std::string, std::string> texts;  // read instead of the files of these absolute paths
  };

  explicit Sandbox(Options options);
  Sandbox(const Sandbox&) = delete;
  Sandbox& operator=(const Sandbox&) = delete;
  // There is no destructor: finalizers of a script could run for ever, so a process that held a sandbox must `_exit`.

  // Calls `function` of scripts/strobe/run.lua with `request` as a table. False after mistakes: see `problems`.
  bool run(const std::string& function, const Json& request, Json& result);

  // Reads what has been loaded ahead of questions about the places in it, for the copies of this process.
  void prepareSources() const;

  const std::vector<Problem>& problems() const { return problems_; }
  const std::vector<Dependency>& files() const { return files_; }
  bool outOfMemory() const { return out_of_memory_; }
  lua_State* state() { return lua_; }

  // The nearest running line of the user's own files, from `level` up the stack.
  static Place userPlace(lua_State* lua, int level);

  // Is a file, as errors name it, not the user's?
  bool isLibrary(std::string_view shown) const { return shown.starts_with(library_); }

 private:
  struct Callbacks;  // the C functions Lua calls
  static void* allocate(void* self, void* block, size_t old_size, size_t new_size);

  void openLibraries();
  void loadPrelude();
  bool guarded(const std::function<void()>& work);
  void resolve(const std::string& module);
  void read(const Path& file, const std::string& shown);
  void list(const std::string& folder);
  bool liesInHome(const Path& file) const;
  bool isThere(const Path& file) const;
  std::vector<std::string> moduleNames() const;
  void collectProblems();
  void addProblem(const std::string& message);
  std::string withFullNames(const std::string& message) const;

  Options options_;
  std::string library_;  // the folder scripts/strobe, as errors name it
  lua_State* lua_ = nullptr;
  size_t used_bytes_ = 0;
  bool out_of_memory_ = false;
  std::vector<Dependency> files_;
  std::map<std::string, Source> sources_;  // by shown name
  std::vector<Problem> problems_;
  std::string text_;                // a callback's result or failure
  plan::Value value_;               // a callback's result
  std::vector<std::string> names_;  // a callback's result
  std::string source_;              // of the module that `resolve` or `read` found
  std::string chunk_;               // "@" and its shown name
};

}  // namespace strobe::script
