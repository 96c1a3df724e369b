// SPDX-License-Identifier: MIT
// Strict reading of one table of a scene's description: every key is read once with its type and range, keys nobody
// asked for are mistakes, and all mistakes are collected with the place of the table they stand in.
#pragma once

#include <set>

#include "scene/scene.h"

namespace strobe::scene {

// Mistakes found so far, as lines "file:line: text".
class Problems {
 public:
  void add(const Place& place, const std::string& text);
  bool empty() const { return lines_.empty(); }
  // Throws one `Error` of all lines, at most 20 of them.
  void throwIfAny() const;

 private:
  std::vector<std::string> lines_;
};

class Fields {
 public:
  // `what` names the table in mistakes ("lathe", "node 'vase'"). Its own "place" is used, else that of `outer`.
  // `json` and `problems` must outlive the reader. Not being a table is a mistake; everything then reads as absent.
  Fields(const Json& json, std::string what, const Place& outer, Problems& problems);

  const Place& place() const { return place_; }
  const std::string& what() const { return what_; }
  void rename(std::string what) { what_ = std::move(what); }
  bool has(const std::string& key) const;
  // The value, or null; marks the key as known.
  const Json* find(const std::string& key);
  const Json* need(const std::string& key);
  void problem(const std::string& text) { problems_.add(place_, what_ + ": " + text); }

  // Each returns the fallback where the key is absent; one without fallback is required.
  double number(const std::string& key, std::optional<double> fallback, double min = -1e9, double max = 1e9);
  int integer(const std::string& key, std::optional<int> fallback, int min, int max);
  bool boolean(const std::string& key, bool fallback);
  std::string text(const std::string& key, std::optional<std::string> fallback = "");
  std::string choice(const std::string& key, const std::string& fallback, const std::vector<std::string>& choices);
  dvec2 vector2(const std::string& key, std::optional<dvec2> fallback, double min = -1e9, double max = 1e9);
  dvec3 vector3(const std::string& key, std::optional<dvec3> fallback, double min = -1e9, double max = 1e9);
  // Three or four numbers; a missing fourth is 1.
  vec4 color(const std::string& key, std::optional<vec4> fallback, double max = 1);
  // A list of lists of `size` numbers (or `size_max` where larger) up to `limit`, between `least` and `most` of them.
  std::vector<std::vector<double>> rows(const std::string& key, size_t size, size_t least, size_t most,
                                        size_t size_max = 0, double limit = 1e9);
  std::vector<double> numbers(const std::string& key, size_t least, size_t most);

  // Reports the keys that were not read.
  void finish();

 private:
  std::vector<double> listOf(const std::string& key, const Json& list, size_t least, size_t most, double min,
                             double max);
  bool inRange(const std::string& key, double value, double min, double max);

  const Json& json_;
  std::string what_;
  Place place_;
  Problems& problems_;
  std::set<std::string> known_ = {"kind", "type", "place"};
};

// "file:line" of a table that says where it was written.
Place placeOf(const Json& json, const Place& otherwise);

}  // namespace strobe::scene
