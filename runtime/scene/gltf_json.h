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

// JSON of a file, with checked access to the members of its objects.
class GltfJson {
 public:
  explicit GltfJson(const Path& shown) : shown_(shown) {}

  const Json& json() const { return json_; }
  // Throws `Error` with the text "file: where: text".
  [[noreturn]] void refuse(const std::string& where, const std::string& text) const;

  // Checked members of JSON objects. A missing list is empty, a missing index is -1. `all` returns a list of the file
  // itself.
  const Json& all(const std::string& key) const { return list(json_, key, ""); }
  const Json& list(const Json& object, const std::string& key, const std::string& where) const;
  const Json& object(const Json& object, const std::string& key, const std::string& where) const;
  // Throws if the object lacks the member.
  void require(const Json& object, const std::string& key, const std::string& where) const;
  // Object of the extension, or an empty object. `present`: true if the extension is present.
  const Json& extension(const Json& object, const std::string& name, bool* present = nullptr) const;
  int index(const Json& object, const std::string& key, const std::string& list_name, const std::string& where) const;
  // List of indices; empty if it is missing.
  std::vector<int> indexList(const Json& object, const std::string& key, const std::string& list_name,
                             const std::string& where) const;
  double number(const Json& object, const std::string& key, double fallback, const std::string& where) const;
  // Number from `low` to `high`. The member is required if `fallback` is absent.
  double numberIn(const Json& object, const std::string& key, std::optional<double> fallback, double low, double high,
                  const std::string& where) const;
  std::vector<double> numbers(const Json& object, const std::string& key, std::vector<double> fallback,
                              const std::string& where) const;
  std::string text(const Json& object, const std::string& key, const std::string& where = "") const;
  // Unique name for each object of a list. The first object with a name keeps the name; later objects get "#2", "#3",
  // ... added. An object without a name becomes PREFIX_INDEX. Generated names differ from the names in the list and
  // from `reserved`.
  std::vector<std::string> uniqueNames(const Json& list, const std::string& prefix,
                                       std::set<std::string> reserved = {}) const;
  bool flag(const Json& object, const std::string& key, const std::string& where) const;
  size_t size(const Json& object, const std::string& key, std::optional<size_t> fallback,
              const std::string& where) const;

 protected:
  Json json_;
  Path shown_;  // the file, as shown in errors
};

// `extras.cuts` of a scene, a node or an animation: increasing times, s. Empty if the extras have another form.
std::vector<double> cutsOf(const GltfJson& file, const Json& object, const std::string& where);

}  // namespace strobe::scene
