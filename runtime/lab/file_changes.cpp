// SPDX-License-Identifier: MIT
#include "lab/file_changes.h"

#include <algorithm>

#include "base/lists.h"
#include "base/log.h"

namespace strobe::lab {

// Longest time between the steps of saving one file, seconds.
static constexpr double kMoment_s = 0.1;

void ChangedFiles::note(const Path& path, const std::string& hash) {
  Noted& noted = noted_[path];
  if (noted.hash != hash) noted = {hash};
}

void ChangedFiles::remember(const Drawing& running, const std::vector<script::Dependency>& tried, bool sound) {
  const size_t noted_before = noted_.size();
  for (const auto& file : tried) note(file.path, file.hash);
  for (const auto* files : {&running.evaluation().scripts, &running.scene().dependencies})
    for (const auto& file : *files) noted_.emplace(file.path, Noted{file.hash});
  auto note_as_it_is = [this](const Path& file) {
    if (!noted_.count(file)) note(file, script::hashOfPath(file));
  };
  const plan::Plan& plan = running.plan();
  for (const auto& node : sound ? std::vector<plan::PlanNode>() : plan.nodes)
    for (const Path& file : graph::shaderFiles(bench_.home(), plan.passOf(node))) {
      std::vector<Path> reached = {file};
      try {
        shader::textWithIncludes(bench_.home(), file, &reached);
      } catch (const Error&) {
        // The compilation reports this error.
      }
      for (const Path& one : reached) note_as_it_is(one);
    }
  for (const auto& [node, pipeline] : running.graph().pipelines())
    for (const auto& [file, hash] : pipeline->sources) note_as_it_is(file);
  // Folders of new files are watched from the next look on, because the picture comes first.
  if (!tried.empty() || noted_.size() > noted_before) watches_all_ = false;
}

void ChangedFiles::watchFolders(const Drawing& running) {
  if (!watch_) watch_ = std::make_unique<FileWatch>();
  watches_all_ = true;
  for (const char* name : {"passes", "shaders", "scripts", "scripts/pipelines", "scripts/scenes"})
    for (const Path& folder : bench_.home().folders(name)) watch_->add(folder), watch_->addBehind(folder);
  for (const auto* files : {&running.evaluation().scripts, &running.scene().dependencies})
    for (const auto& file : *files) watch_->addFlat(file.path.parent_path());
  for (const auto& [path, noted] : noted_) watch_->addBehind(path);
}

// True if the file is missing only for a moment. Editors that keep a backup rename the old file before they write the
// new one.
bool ChangedFiles::isBeingSaved(Noted& noted, const std::string& now) {
  if (!now.empty() || noted.hash.empty()) return noted.gone_at_s = 0, false;
  if (noted.gone_at_s == 0) noted.gone_at_s = clockSeconds();
  return clockSeconds() < noted.gone_at_s + kMoment_s;
}

// Files that changed since they were recorded. With `wait`, a missing file counts as deleted at once.
FileChanges ChangedFiles::changedSince(const Drawing& running, bool wait) {
  FileChanges changes;
  looks_again_ = false;
  auto is_among = [](const std::vector<script::Dependency>& files, const Path& path) {
    return std::any_of(files.begin(), files.end(), [&](const auto& file) { return file.path == path; });
  };
  for (auto& [path, noted] : noted_) {
    if (noted.stamps && noted.stamps->current()) continue;
    noted.stamps.emplace().add(path);
    std::string now = script::hashOfPath(path);
    if (isBeingSaved(noted, now) && !wait) {
      noted.stamps.reset();
      looks_again_ = true;
      continue;
    }
    if (now == noted.hash) continue;
    noted = {now, noted.stamps};
    changes.files.push_back(bench_.home().shown(path));
    // The Lua library is in both lists. A file in neither list was part of a failed attempt.
    bool scene = is_among(running.scene().dependencies, path);
    bool shader = path.extension() == ".glsl" || path.extension() == ".h";
    changes.scene |= scene;
    changes.scripts |= is_among(running.evaluation().scripts, path) || (!scene && !shader);
  }
  return changes;
}

std::optional<FileChanges> ChangedFiles::evaluatedInBackground(bool wait) {
  bool done = wait || pending_->evaluated.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  if (!done) return {};
  FileChanges changes = std::move(pending_->changes);
  changes.evaluated = pending_->evaluated.get();
  pending_.reset();
  return changes;
}

std::optional<FileChanges> ChangedFiles::failureAtItsTime(bool wait) {
  if (!failed_ || (!wait && failed_->mayBeUnfinished())) return {};
  return std::exchange(failed_, {});
}

// Merges earlier failed changes into newer changes.
static void add(FileChanges& changes, const FileChanges& failed) {
  if (changes.files.empty()) changes.show_failure_at_s = failed.show_failure_at_s;
  std::vector<std::string> files = failed.files;
  for (const std::string& file : changes.files) addOnce(files, file);
  changes.files = std::move(files);
  changes.scripts |= failed.scripts;
  changes.scene |= failed.scene;
}

std::optional<FileChanges> ChangedFiles::newChanges(const Running& running, bool first, bool wait) {
  const bool event = watch_->changed();
  FileChanges changes;
  if (event || first || wait || looks_again_) changes = changedSince(running.drawing, wait);
  // After a failure, retry at every event: a file may have appeared that was not known before.
  const bool retry = event && (running.failed || failed_);
  if (changes.files.empty() && !retry) return failureAtItsTime(wait);
  changes.scripts |= running.scripts_failed;
  if (failed_) add(changes, *std::exchange(failed_, {}));
  return changes;
}

std::optional<FileChanges> ChangedFiles::look(const Running& running, bool wait) {
  const bool first = !watches_all_;
  if (first) watchFolders(running.drawing);
  std::optional<FileChanges> changes = pending_ ? evaluatedInBackground(wait) : newChanges(running, first, wait);
  if (!changes) return {};
  // The evaluation is outdated if values were set in the meantime.
  const bool current =
      changes->shot && running.shot.pipeline == changes->shot->pipeline && running.shot.sets == changes->shot->sets;
  if (!current) {
    changes->shot = running.shot;
    auto evaluate = [&home = bench_.home(), shot = running.shot, good = running.drawing.heldEvaluation(),
                     limits = bench_.limits] { return attemptAround(home, shot, *good, limits); };
    if (!changes->scripts) {
      changes->evaluated.good = running.drawing.evaluation();
      changes->evaluated.usable = true;
    } else if (wait) {
      changes->evaluated = evaluate();
    } else {
      pending_ = Pending{std::move(*changes), std::async(std::launch::async, evaluate)};
      return {};
    }
  }
  return changes;
}

bool FileChanges::mayBeUnfinished() const { return show_failure_at_s == 0 || clockSeconds() < show_failure_at_s; }

void ChangedFiles::holdBack(FileChanges failed) {
  failed_ = std::move(failed);
  if (failed_->show_failure_at_s == 0) failed_->show_failure_at_s = clockSeconds() + kMoment_s;
}

}  // namespace strobe::lab
