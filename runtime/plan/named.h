// SPDX-License-Identifier: MIT
// Look-up in lists of items with a field `name`, and in lists of pairs.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace strobe::plan {

// The item with that name; null if it does not exist.
template <class Items>
auto* find(Items& items, const std::string& name) {
  auto found = std::find_if(items.begin(), items.end(), [&](const auto& item) { return item.name == name; });
  return found == items.end() ? nullptr : &*found;
}

// Index of the item with that name; -1 if it does not exist.
template <class Items>
int indexOf(const Items& items, const std::string& name) {
  const auto* found = find(items, name);
  return found ? int(found - items.data()) : -1;
}

// Value of the pair with that key; null if it does not exist.
template <class Pairs>
auto* valueIn(Pairs& pairs, const std::string& key) {
  auto found = std::find_if(pairs.begin(), pairs.end(), [&](const auto& pair) { return pair.first == key; });
  return found == pairs.end() ? nullptr : &found->second;
}

template <class Items>
std::vector<std::string> namesOf(const Items& items) {
  std::vector<std::string> names;
  for (const auto& item : items) names.push_back(item.name);
  return names;
}

}  // namespace strobe::plan
