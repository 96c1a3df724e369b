// SPDX-License-Identifier: MIT
// The JSON of a glTF 2.0 asset. A member is checked when it is read.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/files.h"
#include "base/json.h"

namespace strobe::scene {

// The JSON of a file, with checked access to the members of its objects.
class GltfJson {
 public:
  explicit GltfJson(const Path& shown) : shown_(shown) {}

  const Json& json() const { return json_; }
  // Throws: "file: where: text".
  [[noreturn]] void refuse(const std::string& where, const std::string& text) const;

  // Members of JSON objects, checked. A missing list is empty, a missing index -1. `all`: a list of the file itself.
  const Json& all(const std::string& key) const { return list(json_, key, ""); }
  const Json& list(const Json& object, const std::string& key, const std::string& where) const;
  const Json& object(const Json& object, const std::string& key, const std::string& where) const;
  // Throws where the object does not have the member.
  void require(const Json& object, const std::string& key, const std::string& where) const;
  // The extension's object, or an empty one; `present` says which.
  const Json& extension(const Json& object, const std::string& name, bool* present = nullptr) const;
  int index(const Json& object, const std::string& key, const std::string& list_name, const std::string& where) const;
  // A list of such indices; a missing one is empty.
  std::vector<int> indexList(const Json& object, const std::string& key, const std::string& list_name,
                             const std::string& where) const;
  double number(const Json& object, const std::string& key, double fallback, const std::string& where) const;
  // The same, from `low` to `high`; without a fallback it may not be missing.
  double numberIn(const Json& object, const std::string& key, std::optional<double> fallback, double low, double high,
                  const std::string& where) const;
  std::vector<double> numbers(const Json& object, const std::string& key, std::vector<double> fallback,
                              const std::string& where) const;
  std::string text(const Json& object, const std::string& key, const std::string& where = "") const;
  // A name for each object of a list, all different. The first object with a name keeps it, a later one has "#2", "#3",
  // ... added to it, and one without a name is PREFIX_INDEX. Names made up are none that the list states, nor
  // `reserved`.
  std::vector<std::string> uniqueNames(const Json& list, const std::string& prefix,
                                       std::set<std::string> reserved = {}) const;
  bool flag(const Json& object, const std::string& key, const std::string& where) const;
  size_t size(const Json& object, const std::string& key, std::optional<size_t> fallback,
              const std::string& where) const;

 protected:
  Json json_;
  Path shown_;  // as the file was given
};

// Numbers from 0 to 1.
std::vector<double> sharesOf(const GltfJson& file, const Json& object, const std::string& key,
                             std::vector<double> fallback, const std::string& where);

// `extras.cuts` of a scene, a node or an animation: seconds that increase. Empty if the extras have another form.
std::vector<double> cutsOf(const GltfJson& file, const Json& object, const std::string& where);

}  // namespace strobe::scene
