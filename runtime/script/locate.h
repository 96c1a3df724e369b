// SPDX-License-Identifier: MIT
// Lines of keys in the source of a table. Lua reports the line of a call, but not the lines of the fields of a table.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace strobe::script {

// A Lua source. Its tokens are read at the first use.
class LuaSource {
 public:
  explicit LuaSource(std::string text);
  ~LuaSource();
  LuaSource(const LuaSource&) = delete;
  LuaSource& operator=(const LuaSource&) = delete;

  // Reads the tokens now.
  void prepare() const;

  // Line of a field. `path` {"reads", "depth"} is the field `depth` of the field `reads` of the table that opens on
  // `line` or on the next line. Returns the line of the last key that is found, or `line` without one.
  int lineOfKey(int line, const std::vector<std::string>& path) const;

  // Line of a field in the table after the last `return` on the lines first..last. Returns the line of that `return`
  // without a path, and 0 without a `return`.
  int lineOfReturn(int first, int last, const std::vector<std::string>& path) const;

  // True if the source reads a field `name` of any table: x.name.
  bool readsField(std::string_view name) const;

  // Lines that use `p.name` as a condition or compare it, without a call: `if p.name then`, `not p.name`, `p.name ==
  // 1`.
  std::vector<int> conditionsOn(std::string_view name) const;

 private:
  struct Read;
  const Read& read() const;

  std::string text_;
  mutable std::unique_ptr<const Read> read_;
};

}  // namespace strobe::script
