// SPDX-License-Identifier: MIT
// Search in short lists.
#pragma once

#include <algorithm>

namespace strobe {

template <class List, class Item>
bool contains(const List& list, const Item& item) {
  return std::ranges::find(list, item) != std::ranges::end(list);
}

// Appends the item, unless the list has it.
template <class List, class Item>
void addOnce(List& list, const Item& item) {
  if (!contains(list, item)) list.push_back(item);
}

}  // namespace strobe
