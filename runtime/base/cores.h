// SPDX-License-Identifier: MIT
// Number of cores for this process, and independent work on all cores.
#pragma once

#include <cstddef>
#include <functional>

#include "base/files.h"

namespace strobe {

// Calls `work(0)` to `work(count - 1)`, several at a time, in no order. The first exception of `work` ends the loop and
// is thrown again.
void forEachOnAllCores(size_t count, const std::function<void(size_t)>& work);

// Number of cores that this process may use: `coresOf` the processors of its affinity mask, the quota of its cgroups,
// and the variable SLURM_CPUS_PER_TASK. Constant after the first call.
unsigned allowedCores();
// Least of the number of processors, the quota rounded up (0: no quota) and the cores of the Slurm task (null or not a
// number: no limit); at least 1.
unsigned coresOf(unsigned processors, double quota, const char* of_task);

// Processors of the machine.
unsigned machineCores();

// Lowest CPU quota of the cgroup of this process and of the cgroups above it (versions 1 and 2), in cores; 0: no quota.
// `root` has the folders `proc` and `sys`.
double cgroupQuota(const Path& root = "/");

}  // namespace strobe
