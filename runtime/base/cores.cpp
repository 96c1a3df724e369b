// SPDX-License-Identifier: MIT
#include "base/cores.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <mutex>
#include <thread>
#include <vector>

namespace strobe {

void forEachOnAllCores(size_t count, const std::function<void(size_t)>& work) {
  std::atomic<size_t> next = 0;
  std::exception_ptr failure;
  std::mutex mutex;
  auto take = [&] {
    for (size_t i = next++; i < count; i = next++) try {
        work(i);
      } catch (...) {
        std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
        next = count;
      }
  };
  std::vector<std::jthread> others;
  for (size_t k = 1; k < std::min(size_t(allowedCores()), count); ++k) others.emplace_back(take);
  take();
  others.clear();
  if (failure) std::rethrow_exception(failure);
}

// Cores in a quota file: "QUOTA PERIOD" of cpu.max, or the quota of cpu.cfs_quota_us with its period in another file. 0
// without a file or a quota ("max", -1).
static double quotaIn(const Path& quota_file, const Path& period_file) {
  std::ifstream quota_text(quota_file), period_text(period_file);
  double quota = 0, period = 0;
  if (!(quota_text >> quota)) return 0;
  (period_file.empty() ? quota_text : period_text) >> period;
  return quota > 0 && period > 0 ? quota / period : 0;
}

double cgroupQuota(const Path& root) {
  double least = 0;
  std::ifstream lines(root / "proc/self/cgroup");
  for (std::string line; std::getline(lines, line);) {  // "ID:CONTROLLERS:PATH"; without controllers: version 2
    const size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    const bool is_first_version = controllers.find(",cpu,") != std::string::npos;
    if (!is_first_version && controllers != ",,") continue;
    const Path mount = root / (is_first_version ? "sys/fs/cgroup/cpu" : "sys/fs/cgroup");
    for (Path group = Path(line.substr(second + 1)).relative_path();; group = group.parent_path()) {
      const Path folder = mount / group;
      const double cores = is_first_version ? quotaIn(folder / "cpu.cfs_quota_us", folder / "cpu.cfs_period_us")
                                            : quotaIn(folder / "cpu.max", {});
      if (cores > 0 && (least == 0 || cores < least)) least = cores;
      if (group.empty()) break;
    }
  }
  return least;
}

unsigned machineCores() { return unsigned(std::max(1L, ::sysconf(_SC_NPROCESSORS_ONLN))); }

unsigned coresOf(unsigned processors, double quota, const char* of_task) {
  unsigned cores = std::max(1u, processors);
  if (quota > 0) cores = std::min(cores, unsigned(std::ceil(quota)));
  if (const int count = of_task ? std::atoi(of_task) : 0; count > 0) cores = std::min(cores, unsigned(count));
  return cores;
}

unsigned allowedCores() {
  static const unsigned cores =
      coresOf(std::thread::hardware_concurrency(), cgroupQuota(), std::getenv("SLURM_CPUS_PER_TASK"));
  return cores;
}

}  // namespace strobe
