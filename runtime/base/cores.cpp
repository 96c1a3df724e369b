// SPDX-License-Identifier: MIT
#include "base/cores.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace strobe {

void forEachOnAllCores(size_t count, const std::function<void(size_t)>& work) {
  std::atomic<size_t> next = 0;
  auto take = [&] {
    for (size_t i = next++; i < count; i = next++) work(i);
  };
  size_t cores = std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::jthread> others;
  for (size_t k = 1; k < std::min(cores, count); ++k) others.emplace_back(take);
  take();
}

}  // namespace strobe
