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
#include "base/json_fwd.h"
#include "base/stamps.h"
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
  // What scripts are run for.
  struct Task {
    Path main;                // the file that `native.main` runs
    std::string shown;        // how errors name it
    bool own_folder = false;  // its folder is searched by `require` too
    Path preset;              // the file that `native.preset` runs, or ""
    std::string preset_shown;
    std::map<std::string, std::string> texts;  // read instead of the files of these absolute paths
  };

  explicit Sandbox(Home home, size_t memory_bytes = size_t{256} << 20);
  Sandbox(const Sandbox&) = delete;
  Sandbox& operator=(const Sandbox&) = delete;
  // There is no destructor: finalizers of a script could run for ever, so a process that held a sandbox must `_exit`.

  // Reads and compiles files, called `shown` in errors, before it is known whether they are asked for. One that changes
  // after that is read again, and one that cannot be read is left out.
  void readAhead(const Path& file, const std::string& shown);

  // Before the first `run`.
  void setTask(Task task) { task_ = std::move(task); }
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
  struct Callbacks;  // what Lua calls (callbacks.h)
  static void* allocate(void* self, void* block, size_t old_size, size_t new_size);

  // A file that was read ahead of what asks for it.
  struct Ahead {
    std::string shown, text, hash;
    Stamps stamps;  // from before it was read
    int chunk = 0;  // the function, by its number in the registry
    std::map<std::string, Source>::node_type source;
  };

  void openLibraries();
  void loadPrelude();
  bool guarded(const std::function<void()>& work);
  void resolve(const std::string& module);
  void read(const Path& file, const std::string& shown);
  Ahead* stillAhead(const Path& file);
  void take(const Path& file, Ahead& ahead);
  bool takeAhead(const Path& relative);
  void list(const std::string& folder);
  bool liesInHome(const Path& file) const;
  bool isThere(const Path& file) const;
  std::vector<std::string> moduleNames() const;
  void collectProblems();
  void addProblem(const std::string& message);
  std::string withFullNames(const std::string& message) const;

  Home home_;
  size_t memory_bytes_;
  Task task_;
  std::string library_;  // the folder scripts/strobe, as errors name it
  lua_State* lua_ = nullptr;
  size_t used_bytes_ = 0;
  bool out_of_memory_ = false;
  std::vector<Dependency> files_;
  std::map<std::string, Source> sources_;  // by shown name
  std::map<std::string, Ahead> ahead_;     // by path
  std::vector<Problem> problems_;
  std::string text_;                // a callback's result or failure
  plan::Value value_;               // a callback's result
  std::vector<std::string> names_;  // a callback's result
  std::string source_;              // of the module that `resolve` or `read` found
  std::string chunk_;               // "@" and its shown name
  int ready_chunk_ = 0;             // the function of that text, where it was compiled ahead
};

}  // namespace strobe::script
