// SPDX-License-Identifier: MIT
#include "base/stamps.h"

#include <sys/stat.h>
#include <time.h>

#include <algorithm>

namespace strobe {

static constexpr int64_t kTick_ns = 50'000'000;

static int64_t nanoseconds(const timespec& time) { return int64_t(time.tv_sec) * 1'000'000'000 + time.tv_nsec; }

Stamps::Stamp Stamps::stampOf(const Path& path) {
  Stamp stamp{path};
  struct stat found {};
  if (::stat(path.c_str(), &found) != 0) return stamp;
  timespec now{};
  ::clock_gettime(CLOCK_REALTIME, &now);
  stamp.inode = found.st_ino;
  stamp.bytes = found.st_size;
  stamp.changed_ns = nanoseconds(found.st_ctim);
  stamp.settled = stamp.changed_ns < nanoseconds(now) - kTick_ns;
  return stamp;
}

void Stamps::add(const Path& path) { stamps_.push_back(stampOf(path)); }

bool Stamps::current() const {
  return std::all_of(stamps_.begin(), stamps_.end(),
                     [](const Stamp& stamp) { return stamp.settled && stampOf(stamp.path) == stamp; });
}

}  // namespace strobe
