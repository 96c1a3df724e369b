// SPDX-License-Identifier: MIT
// Independent work on all cores.
#pragma once

#include <cstddef>
#include <functional>

namespace strobe {

// Calls `work(0)` to `work(count - 1)`, several at a time, in no order. The first exception of `work` ends the loop and
// is thrown again.
void forEachOnAllCores(size_t count, const std::function<void(size_t)>& work);

}  // namespace strobe
