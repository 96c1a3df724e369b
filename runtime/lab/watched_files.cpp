// SPDX-License-Identifier: MIT
#include "lab/watched_files.h"

namespace strobe::lab {

void WatchedFiles::tried(const std::vector<script::Dependency>& files) {
  for (const auto& file : files) noted_[file.path] = file.hash;
}

void WatchedFiles::add(const std::vector<script::Dependency>& files) {
  for (const auto& file : files) noted_.emplace(file.path, file.hash);
}

void WatchedFiles::add(const Path& file) {
  if (!noted_.count(file)) noted_[file] = script::hashOfPath(file);
}

bool WatchedFiles::watch(const std::vector<Path>& deep) {
  bool first = !watch_;
  if (first) watch_ = std::make_unique<Watch>();
  for (const Path& folder : deep) watch_->add(folder);
  return first;
}

void WatchedFiles::watchFlat(const std::vector<script::Dependency>& files) {
  for (const auto& file : files) watch_->addFlat(file.path.parent_path());
}

std::vector<Path> WatchedFiles::takeChanged() {
  std::vector<Path> changed;
  for (auto& [path, hash] : noted_) {
    std::string now = script::hashOfPath(path);
    if (now == hash) continue;
    hash = now;
    changed.push_back(path);
  }
  return changed;
}

}  // namespace strobe::lab
