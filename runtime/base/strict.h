// SPDX-License-Identifier: MIT
// Strict reader of one table of data from a script or another program. Every key is read with its type and range. Keys
// that are not read are mistakes. Each mistake names the table, its place and the key.
#pragma once

#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/json_fwd.h"

namespace strobe {

// Mistakes as lines "file:line: text". With `at_once`, each mistake is thrown immediately.
class Problems {
 public:
  enum class When { at_the_end, at_once };
  explicit Problems(When when = When::at_the_end) : when_(when) {}
  void add(const Place& place, const std::string& text);
  bool empty() const { return lines_.empty(); }
  // Throws one `Error` with all different lines, at most 20.
  void throwIfAny() const;

 private:
  When when_;
  std::vector<std::string> lines_;
};

// Reader of a JSON object that checks the type and range of each value and reports keys that were not read.
class Fields {
 public:
  // `what` names the table in mistakes ("lathe", "node 'vase'"). The place is the table's own "place", or `outer`
  // without one. `json` and `problems` must outlive the reader. If `json` is not a table, that is a mistake, and all
  // keys are absent. An empty list counts as an empty table, because Lua has one type for both.
  Fields(const Json& json, std::string what, const Place& outer, Problems& problems);

  const Place& place() const { return place_; }
  const std::string& what() const { return what_; }
  void rename(std::string what) { what_ = std::move(what); }
  void setPlace(const Place& place) { place_ = place; }
  // Both mark the key as known. `find` returns the value, or null.
  bool has(const std::string& key);
  const Json* find(const std::string& key);
  // A key that another reader reads: known, and never suggested.
  void allow(const std::string& key) { allowed_.insert(key); }
  const Json* need(const std::string& key);
  void problem(const std::string& text) { problems_.add(place_, what_ + ": " + text); }

  // Each function returns the fallback if the key is absent. A key without fallback is required.
  double number(const std::string& key, std::optional<double> fallback, double min = -1e9, double max = 1e9);
  int integer(const std::string& key, std::optional<int> fallback, int min, int max);
  bool boolean(const std::string& key, bool fallback);
  std::string text(const std::string& key, const std::optional<std::string>& fallback = "");
  std::string choice(const std::string& key, const std::optional<std::string>& fallback,
                     const std::vector<std::string>& choices);
  // A list or a table of at most `most` entries; empty if the key is absent.
  const Json& list(const std::string& key, size_t most = 100000);
  const Json& table(const std::string& key, size_t most = 100000);
  std::vector<std::string> texts(const std::string& key);
  // A list of `least` to `most` lists. Each has `size` numbers (or up to `size_max`, if that is larger) between
  // -`limit` and `limit`.
  std::vector<std::vector<double>> rows(const std::string& key, size_t size, size_t least, size_t most,
                                        size_t size_max = 0, double limit = 1e9);
  std::vector<double> numbers(const std::string& key, size_t least, size_t most);

  // Reports the keys that were not read.
  void finish();

 protected:
  std::vector<double> listOf(const std::string& key, const Json& list, size_t least, size_t most, double min,
                             double max);

 private:
  bool inRange(const std::string& key, double value, double min, double max);
  const Json& collection(const std::string& key, bool is_list, size_t most);

  const Json& json_;
  std::string what_;
  Place place_;
  Problems& problems_;
  std::set<std::string> known_, allowed_ = {"place"};
};

// Place of a table from its field "place"; `otherwise` if the field is missing or wrong.
Place placeOf(const Json& json, const Place& otherwise);

}  // namespace strobe
