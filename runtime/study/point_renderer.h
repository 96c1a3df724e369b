// SPDX-License-Identifier: MIT
// Draws and measures the tasks of a sweep that are missing in its store.
#pragma once

#include <set>

#include "study/tasks.h"
#include "study/worker.h"

namespace strobe::study {

// Runs `step`. Returns the reason of its failure, "" without one. Rethrows failures that end the run: a file that
// cannot be written, a lost device.
std::string failureOf(const std::function<void()>& step);

// Renders the pictures of an experiment, measures them against ground truth and stores the results; finished points
// are skipped.
class PointRenderer {
 public:
  using Progress = std::function<void(int cost)>;

  // Draws the results in `missing`: number of failed tries so far, by key. All references must outlive the renderer.
  PointRenderer(const Experiment& experiment, lab::Batch& batch, const Store& store, Worker& worker,
                std::map<std::string, size_t> missing)
      : experiment_(experiment), batch_(batch), store_(store), worker_(worker), missing_(std::move(missing)) {}

  // Draws, measures and stores a point for each missing result of the group. The point of a failed task has the reason.
  // Returns false if another program draws one of the points, so that results are left. Throws `Error` if the store
  // cannot write, and `Stopped`.
  bool render(const TaskGroup& group, const Progress& progress);

  // Time spent so far, seconds.
  struct Spent {
    double drawing_s = 0, measuring_s = 0, keeping_s = 0;
    double sum() const { return drawing_s + measuring_s + keeping_s; }
  };
  const Spent& spent() const { return spent_; }

 private:
  bool isMissing(const Task& task);
  void renderTask(const TaskGroup& group, const Task& task);
  std::shared_ptr<const lab::Picture> drawn(const lab::Shot& shot, int cost);
  std::shared_ptr<const lab::Picture> drawnTruth(const lab::Shot& shot, int cost);
  void prepareTruth(const TaskGroup& group);
  void loadTruth(const TaskGroup& group);
  MeasureInput inputOf(const TaskGroup& group, const Task& task, const lab::Picture& picture, size_t frame);
  Point measuredPoint(const TaskGroup& group, const Task& task);
  void noteFile(Point& point, const Path& file, const std::string& content) const;
  void keepFiles(const TaskGroup& group, const Task& task, const lab::Picture& picture, Point& point);
  void write(const TaskGroup& group, const Task& task, const lab::Picture& picture, Point& point);
  void warnOnce(const std::string& who, const std::vector<std::string>& warnings);

  const Experiment& experiment_;
  lab::Batch& batch_;
  const Store& store_;
  Worker& worker_;
  std::map<std::string, size_t> missing_;
  Progress progress_;
  Spent spent_;
  int cost_ = 0;       // of the points drawn so far
  size_t points_ = 0;  // drawn so far, without truths

  std::vector<std::string> truth_keys_;  // keys of the loaded truths, by frame
  std::vector<std::shared_ptr<const lab::Picture>> truths_;
  std::vector<TruthPicture> held_against_;
  image::Image benign_, front_;                                    // references of the current picture
  std::map<std::vector<std::string>, std::string> failed_truths_;  // reasons, by content
  std::set<std::string> warned_;
};

}  // namespace strobe::study
