// SPDX-License-Identifier: MIT
#include "mutate/home_copy.h"

#include <sys/inotify.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>

#include "base/error.h"

namespace strobe::mutate {

namespace fs = std::filesystem;

HomeCopy::HomeCopy(const Path& home) {
  static std::atomic<int> count = 0;
  folder_ = fs::temp_directory_path() / fmt::format("strobe_mutant_{}_{}", ::getpid(), count++);
  for (const char* part : {"passes", "shaders", "scripts"}) {
    fs::create_directories(folder_ / part);
    fs::copy(home / part, folder_ / part, fs::copy_options::recursive);
  }
}

HomeCopy::~HomeCopy() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

OpenedFiles::OpenedFiles(const Path& folder) : descriptor_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
  auto add = [&](const Path& one, const std::string& name) {
    int watch = ::inotify_add_watch(descriptor_, one.c_str(), IN_OPEN | IN_ONLYDIR);
    if (watch < 0) throw Error(fmt::format("cannot be watched: {}", std::strerror(errno)), {one.string()});
    folders_.push_back({watch, name});
  };
  add(folder, "");
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_directory()) add(entry.path(), entry.path().lexically_relative(folder).string() + "/");
}

OpenedFiles::~OpenedFiles() { ::close(descriptor_); }

bool OpenedFiles::collect(std::vector<std::string>& files) {
  bool complete = true;
  alignas(inotify_event) char buffer[65536];
  for (ssize_t got; (got = ::read(descriptor_, buffer, sizeof buffer)) > 0;) {
    for (ssize_t at = 0; at < got;) {
      const auto& event = *reinterpret_cast<const inotify_event*>(buffer + at);
      at += ssize_t(sizeof event + event.len);
      complete = complete && !(event.mask & IN_Q_OVERFLOW);
      for (const auto& [watch, name] : folders_)
        if (watch == event.wd && event.len > 0 && !(event.mask & IN_ISDIR)) files.push_back(name + event.name);
    }
  }
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return complete;
}

}  // namespace strobe::mutate
