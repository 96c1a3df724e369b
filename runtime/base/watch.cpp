// SPDX-License-Identifier: MIT
#include "base/watch.h"

#include <sys/inotify.h>
#include <unistd.h>

#include <algorithm>

namespace strobe {

namespace fs = std::filesystem;

// In-place saves are seen when the file is closed, never half written; of what is created, only folders matter.
static constexpr uint32_t kEvents =
    IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE | IN_CREATE | IN_DELETE_SELF | IN_ONLYDIR;

Watch::Watch() : descriptor_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {}

Watch::~Watch() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void Watch::addOne(const Path& folder) {
  auto known = std::find_if(folders_.begin(), folders_.end(), [&](const auto& held) { return held.second == folder; });
  if (known != folders_.end()) return;
  int watch = ::inotify_add_watch(descriptor_, folder.c_str(), kEvents);
  if (watch >= 0) folders_[watch] = folder;
}

void Watch::add(const Path& folder) {
  std::error_code ignored;
  if (descriptor_ < 0 || !fs::is_directory(folder, ignored)) return;
  addOne(folder);
  for (auto it = fs::recursive_directory_iterator(folder, ignored); it != fs::recursive_directory_iterator();
       it.increment(ignored))
    if (it->is_directory(ignored)) addOne(it->path());
}

bool Watch::changed() {
  if (descriptor_ < 0) return true;
  bool changed = false;
  alignas(inotify_event) char buffer[16384];
  for (ssize_t got; (got = ::read(descriptor_, buffer, sizeof buffer)) > 0;) {
    for (ssize_t at = 0; at < got;) {
      const auto& event = *reinterpret_cast<const inotify_event*>(buffer + at);
      at += ssize_t(sizeof event + event.len);
      bool folder = event.mask & IN_ISDIR;
      bool appeared = event.mask & (IN_CREATE | IN_MOVED_TO);
      auto parent = folders_.find(event.wd);
      if (folder && appeared && parent != folders_.end()) add(Path(parent->second) / event.name);
      if (event.mask & (IN_DELETE_SELF | IN_IGNORED) && parent != folders_.end()) folders_.erase(parent);
      changed |= folder || !(event.mask & IN_CREATE);
    }
  }
  return changed;
}

}  // namespace strobe
