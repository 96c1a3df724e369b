// SPDX-License-Identifier: MIT
// A Lua state with a whitelisted environment, for the scripts of a script child.
//
// Lua raises errors by jumping over C++ frames, and C++ exceptions must not cross Lua's frames. So every callback first
// takes its arguments. Then it does its C++ work inside `guarded`, which catches all exceptions. A Lua error is raised
// only from the member `text_`, when no object in the callback's frame needs a destructor.
#pragma once

#include <functional>
#include <lua.hpp>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/home.h"
#include "base/json_fwd.h"
#include "base/stamps.h"
#include "script/evaluate.h"
#include "script/locate.h"

namespace strobe::script {

// A mistake, with the place of the user's line.
struct Problem {
  Place place;
  std::string message;
};

// Lua state for scripts of the user, with whitelisted functions and a memory limit. Records the files that a script
// reads and the mistakes with their places.
class Sandbox {
 public:
  // Files of a run.
  struct Task {
    Path main;                // the file that `native.main` runs
    std::string shown;        // name of the file in errors
    bool own_folder = false;  // `require` also searches the folder of the file
    Path preset;              // the file that `native.preset` runs, or ""
    std::string preset_shown;
    std::map<std::string, std::string> texts;  // texts in place of files, by absolute path
    size_t memory_bytes = size_t{256} << 20;   // limit of Lua's heap
  };

  explicit Sandbox(Home home);
  Sandbox(const Sandbox&) = delete;
  Sandbox& operator=(const Sandbox&) = delete;
  // No destructor: finalizers of a script could run without end, so a process with a sandbox must end with `_exit`.

  // Reads and compiles a file before a script requires it; `shown` is its name in errors. A file that changes later is
  // read again. A file that cannot be read is left out.
  void compileAhead(const Path& file, const std::string& shown);

  void setTask(Task task) { task_ = std::move(task); }
  // Calls `function` of scripts/strobe/run.lua with `request` as a table. False after mistakes, which are in
  // `problems`.
  bool run(const std::string& function, const Json& request, Json& result);

  // Reads the tokens of the loaded sources now, so that forked copies of this process share them.
  void prepareSources() const;

  const std::vector<Problem>& problems() const { return problems_; }
  const std::vector<Dependency>& files() const { return files_; }
  // Stamps of these files, taken before they were read, and of folders that may get a file in their place.
  const Stamps& stamps() const { return stamps_; }
  bool outOfMemory() const { return out_of_memory_; }
  lua_State* state() { return lua_; }

  // Place of the nearest running line of the user's files, from `level` up the stack.
  static Place userPlace(lua_State* lua, int level);

  // True if the file belongs to the library; `shown` is its name in errors.
  bool isLibrary(std::string_view shown) const { return shown.starts_with(library_); }

 private:
  struct Callbacks;  // functions for Lua (callbacks.h)
  static void* allocate(void* self, void* block, size_t old_size, size_t new_size);

  // A file that was read before a script required it.
  struct Ahead {
    std::string shown, text, hash;
    Stamps stamps = {};  // taken before the file was read
    int chunk = 0;       // number of the compiled function in the registry
    std::map<std::string, LuaSource>::node_type source = {};
  };

  void openLibraries();
  void loadPrelude();
  bool guarded(const std::function<void()>& work);
  void resolve(const std::string& module);
  void noteState(const Path& file);
  void read(const Path& file, const std::string& shown);
  Ahead* stillAhead(const Path& file);
  void take(const Path& file, Ahead& ahead);
  bool takeAhead(const Path& relative);
  void list(const std::string& folder);
  bool isThere(const Path& file) const;
  std::vector<std::string> moduleNames() const;
  void collectProblems();
  void addProblem(const std::string& message);
  std::string withFullNames(const std::string& message) const;

  Home home_;
  Task task_;
  std::string library_;  // the folder scripts/strobe, as in errors
  lua_State* lua_ = nullptr;
  size_t used_bytes_ = 0;
  bool out_of_memory_ = false;
  std::vector<Dependency> files_;
  Stamps stamps_;
  std::set<Path> folders_;                    // folders in `stamps_`
  std::map<std::string, LuaSource> sources_;  // by shown name
  std::map<std::string, Ahead> ahead_;        // by path
  std::vector<Problem> problems_;
  std::string text_;                // result or error of a callback
  plan::Value value_;               // result of a callback
  std::vector<std::string> names_;  // result of a callback
  std::string source_;              // text of the module that `resolve` or `read` found
  std::string chunk_;               // "@" and the shown name of `source_`
  int ready_chunk_ = 0;             // number of the compiled function of `source_`; 0 if not compiled
};

}  // namespace strobe::script
