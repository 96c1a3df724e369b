// SPDX-License-Identifier: MIT
// The line of a key in the source of a table: Lua knows the line of a call, not of the fields in its braces.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace strobe::script {

// A source and, once anything is asked about it, what stands where in it.
class Source {
 public:
  explicit Source(std::string text);
  ~Source();
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  // Reads it ahead of the questions.
  void prepare() const;

  // `path` {"reads", "depth"} is the field `depth` of the field `reads` of the table that opens on `line` or the next.
  // The line of its last key, or of the last one that the source shows, or `line` itself.
  int lineOfKey(int line, const std::vector<std::string>& path) const;

  // The same for the table behind the last `return` on the lines first..last; without a path the line of that `return`,
  // 0 when there is none.
  int lineOfReturn(int first, int last, const std::vector<std::string>& path) const;

  // Whether it reads a field `name` of anything: x.name.
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
