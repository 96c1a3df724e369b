// SPDX-License-Identifier: MIT
// Draws and measures the tasks of a sweep that its store does not have yet.
#pragma once

#include <set>

#include "study/tasks.h"

namespace strobe::study {

// Where a crop lies in a picture of truth; `size` is that of one placed where most of the inner blur is.
image::Rectangle placedCrop(const Experiment& experiment, const Crop& crop, const PicturesLayout& size,
                            const TruthPicture& truth);

// Truth with what is asked of it.
TruthPicture truthPictureOf(const Experiment& experiment, const lab::Picture& truth);

class PointRenderer {
 public:
  using Progress = std::function<void(int cost)>;

  // All must outlive it.
  PointRenderer(const Experiment& experiment, lab::Batch& batch, const Store& store)
      : experiment_(experiment), batch_(batch), store_(store), pictures_(picturesLayoutOf(experiment.layout)) {}

  // Keeps a point for each task that has none, with the reason where it cannot be drawn. Throws `Error` where the store
  // cannot keep it.
  void render(const TaskGroup& group, const Progress& progress);

  // The first truth of a group: from the store, or drawn where the store does not have it.
  std::shared_ptr<const lab::Picture> firstTruth(const TaskGroup& group);

  // Seconds so far.
  struct Spent {
    double drawing_s = 0, measuring_s = 0, keeping_s = 0;
  };
  const Spent& spent() const { return spent_; }

 private:
  void renderTask(const TaskGroup& group, const Task& task);
  std::shared_ptr<const lab::Picture> drawn(const lab::Shot& shot, int cost);
  std::shared_ptr<const lab::Picture> drawnTruth(const lab::Shot& shot, int cost);
  void prepareTruth(const TaskGroup& group);
  void loadTruth(const TaskGroup& group);
  Sight sightOf(const TaskGroup& group, const Task& task, const lab::Picture& picture, size_t frame);
  Point measuredPoint(const TaskGroup& group, const Task& task);
  void noteFile(Point& point, const Path& file) const;
  void keepFiles(const TaskGroup& group, const Task& task, const lab::Picture& picture, Point& point);
  void write(const TaskGroup& group, const Task& task, const lab::Picture& picture, Point& point);
  void warnOnce(const std::string& who, const std::vector<std::string>& warnings);

  const Experiment& experiment_;
  lab::Batch& batch_;
  const Store& store_;
  const std::optional<PicturesLayout> pictures_;
  Progress progress_;
  Spent spent_;

  std::vector<std::string> truth_keys_;  // of the truths that are held, by frame
  std::vector<std::shared_ptr<const lab::Picture>> truths_;
  std::vector<TruthPicture> held_against_;
  image::Image benign_, front_;                                    // what the picture at hand is compared with
  std::map<std::vector<std::string>, std::string> failed_truths_;  // why, by content
  std::set<std::string> warned_;
};

}  // namespace strobe::study
