// SPDX-License-Identifier: MIT
#include "base/watch.h"

#include <sys/inotify.h>
#include <unistd.h>

#include "base/log.h"

namespace strobe {

namespace fs = std::filesystem;

// An in-place save counts when the file is closed. A creation counts for folders and links only.
static constexpr uint32_t kEvents =
    IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE | IN_CREATE | IN_DELETE_SELF | IN_ONLYDIR;

// Time between true results if the system cannot watch, seconds.
static constexpr double kBlindly_s = 0.1;

FileWatch::FileWatch() : descriptor_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {}

FileWatch::~FileWatch() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

// The system returns the same descriptor for a folder that is watched already, under any of its names.
void FileWatch::addOne(const Folder& folder) {
  int watch = ::inotify_add_watch(descriptor_, folder.path.c_str(), kEvents);
  if (watch < 0) return;
  Folder& held = folders_[watch];
  held = {folder.path, held.deep || folder.deep};
}

void FileWatch::addFlat(const Path& folder) { addOne({folder, false}); }

void FileWatch::addBehind(const Path& link) {
  constexpr int kMostLinks = 40;  // limit of the system
  std::error_code failed;
  Path at = link;
  for (int i = 0; i < kMostLinks && fs::is_symlink(at, failed); ++i) {
    addFlat(at.parent_path());
    at = at.parent_path() / fs::read_symlink(at, failed);
    addFlat(at.parent_path());
  }
}

void FileWatch::add(const Path& folder) {
  std::error_code ignored;
  if (descriptor_ < 0 || !fs::is_directory(folder, ignored)) return;
  addOne({folder, true});
  for (auto it = fs::recursive_directory_iterator(folder, ignored); it != fs::recursive_directory_iterator();
       it.increment(ignored)) {
    if (it->is_symlink(ignored)) addBehind(it->path());
    if (it->is_directory(ignored)) addOne({it->path(), true});
  }
}

// True for a link, symbolic or hard. A link is complete at once: no event for the end of a write follows.
static bool isLink(const Path& file) {
  std::error_code ignored;
  return fs::is_symlink(file, ignored) || fs::hard_link_count(file, ignored) > 1;
}

bool FileWatch::changed() {
  if (descriptor_ < 0) {
    if (clockSeconds() < look_again_s_) return false;
    look_again_s_ = clockSeconds() + kBlindly_s;
    return true;
  }
  bool changed = false;
  alignas(inotify_event) char buffer[16384];
  for (ssize_t got; (got = ::read(descriptor_, buffer, sizeof buffer)) > 0;) {
    for (ssize_t at = 0; at < got;) {
      const auto& event = *reinterpret_cast<const inotify_event*>(buffer + at);
      at += ssize_t(sizeof event + event.len);
      bool folder = event.mask & IN_ISDIR;
      bool appeared = event.mask & (IN_CREATE | IN_MOVED_TO);
      auto parent = folders_.find(event.wd);
      const Path file = parent != folders_.end() && event.len > 0 ? parent->second.path / event.name : Path();
      const bool link = appeared && !folder && !file.empty() && isLink(file);
      if (appeared && !file.empty() && parent->second.deep) folder ? add(file) : addBehind(file);
      if (event.mask & (IN_DELETE_SELF | IN_IGNORED) && parent != folders_.end()) folders_.erase(parent);
      changed |= folder || link || !(event.mask & IN_CREATE);
    }
  }
  return changed;
}

}  // namespace strobe
