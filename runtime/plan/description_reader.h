// SPDX-License-Identifier: MIT
// Reader of the canonical form of passes and pipelines.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/json.h"
#include "base/strict.h"
#include "plan/description.h"
#include "plan/named.h"

namespace strobe::plan {

// A table of the canonical form. Throws `Error` at the first mistake; `what` names the table in errors ("pass 'x'").
class Reader : public Fields {
 public:
  Reader(const Json& json, std::string what, const Place& outer = {})
      : Fields(json, std::move(what), outer, thrownAtOnce()) {}

  const Json& at(const char* key) { return *need(key); }

  std::optional<double> number(const char* key) {
    constexpr double kMost = std::numeric_limits<double>::max();
    return has(key) ? std::optional(Fields::number(key, std::nullopt, -kMost, kMost)) : std::nullopt;
  }

  size_t oneOf(const char* key, const std::vector<std::string>& names) {
    std::string name = choice(key, std::nullopt, names);
    return static_cast<size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  }

  [[noreturn]] void fail(const std::string& message) const { throw Error(what() + ": " + message, place()); }

 private:
  static Problems& thrownAtOnce();
};

// True if `name` is a letter a-z, then a-z, 0-9 and _; at most 64 characters.
bool isName(const std::string& name);

// True if `name` consists of names separated by slashes: "folder/name".
bool isPath(const std::string& name);
std::string nameOf(Reader& reader);

// Reads each entry of `json` with `read`. All entries must be of the kind that `read` accepts.
template <class Read>
auto itemsOf(const Json& json, Read read) {
  std::vector<decltype(read(json))> items;
  for (const Json& entry : json) items.push_back(read(entry));
  return items;
}

// Entries of a table of texts, by name.
std::vector<std::pair<std::string, std::string>> textsByName(Reader& reader, const char* key);

// Broken invariants with their reasons.
Breaks breaksOf(const Reader& reader, const Json& json);

ParamDesc readParam(const Json& json);

}  // namespace strobe::plan
