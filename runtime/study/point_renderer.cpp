// SPDX-License-Identifier: MIT
#include "study/point_renderer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/hash.h"
#include "base/log.h"
#include "image/metrics.h"
#include "image/png.h"
#include "lab/against_truth.h"
#include "lab/capture.h"
#include "study/crops.h"
#include "study/points.h"

namespace strobe::study {

using image::Image;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// "NODE: COUNT WHAT" of each limit a picture met: its warnings without those of the scene, without what to do about
// them.
std::vector<std::string> limitsMet(const lab::Picture& picture) {
  std::vector<std::string> met, of_scene = picture.record["scene"]["warnings"].get<std::vector<std::string>>();
  for (const std::string& warning : picture.warnings)
    if (std::find(of_scene.begin(), of_scene.end(), warning) == of_scene.end())
      met.push_back(warning.substr(0, warning.find(';')));
  return met;
}

}  // namespace

image::Rectangle placedCrop(const Experiment& experiment, const Crop& crop, const PicturesLayout& size,
                            const TruthPicture& truth) {
  double scale_x = double(experiment.width) / experiment.file_width,
         scale_y = double(experiment.height) / experiment.file_height;
  if (crop) return scaledCrop(*crop, scale_x, scale_y, truth.color);
  image::Rectangle scaled = scaledCrop({0, 0, size.crop_width, size.crop_height}, scale_x, scale_y, truth.color);
  auto inner = truth.masks.find("inner");
  if (inner != truth.masks.end()) return densestCrop(inner->second, scaled.width, scaled.height);
  return {(truth.color.width - scaled.width) / 2, (truth.color.height - scaled.height) / 2, scaled.width,
          scaled.height};
}

TruthPicture truthPictureOf(const Experiment& experiment, const lab::Picture& picture) {
  TruthPicture truth;
  truth.color = lab::colorOf(picture);
  for (const std::string& region : experiment.regions) {
    truth.masks[region] = lab::maskOf(picture, region);
    truth.sigma[region] = lab::sigmaOf(picture, truth.masks[region]);
  }
  truth.exposures = image::automaticExposures(truth.color, truth.color);
  return truth;
}

// Progress counts what is drawn, not what is known already.
std::shared_ptr<const lab::Picture> PointRenderer::drawn(const lab::Shot& shot, int cost) {
  int last = 0;
  std::shared_ptr<const lab::Picture> picture = batch_.picture(shot, {}, [&](int done, int of) {
    int now = int(int64_t(cost) * done / std::max(of, 1));
    progress_(now - last);
    last = now;
  });
  progress_(cost - last);
  return picture;
}

// With as many samples as its standard error, which falls with their root, asks for.
std::shared_ptr<const lab::Picture> PointRenderer::drawnTruth(const lab::Shot& first, int cost) {
  lab::Shot shot = first;
  std::shared_ptr<const lab::Picture> picture = drawn(shot, cost);
  const double required = experiment_.truth_error > 0 ? experiment_.truth_error : kInfinity;
  for (double error; (error = lab::sigmaOf(*picture, {})) > required; picture = drawn(shot, 0)) {
    std::shared_ptr<const plan::PipelineDesc> pipeline = batch_.evaluate(shot.pipeline, shot.sets).pipeline;
    const plan::ParamDesc* samples = plan::paramOf(*pipeline, plan::Role::SampleCount);
    if (!samples) throw Error("has no parameter that is a number of samples", {shot.pipeline});
    int64_t now = 0;
    for (const auto& [name, value] : pipeline->values)
      if (name == samples->name) now = std::get<int64_t>(value);
    double needed = std::ceil(1.1 * double(now) * std::pow(error / required, 2));
    int64_t next = int64_t(std::min(needed, samples->max.value_or(needed)));
    if (next <= now)
      throw Error(fmt::format("truth has a standard error of {:.3g} with the {} samples it can have, not {:.3g}", error,
                              now, required));
    lab::putSetting(shot.sets, samples->name, next);
  }
  return picture;
}

// Read, or drawn, when a point of the group is first measured.
void PointRenderer::prepareTruth(const TaskGroup& group) {
  if (truth_key_ == group.truth_key + group.full_key) return;
  // What failed once is not drawn again for every arm.
  std::string& failed = failed_truths_[group.truth_key + group.full_key];
  if (!failed.empty()) throw Error(failed);
  try {
    loadTruth(group);
  } catch (const WriteError&) {
    throw;
  } catch (const Error& error) {
    failed = error.what();
    throw;
  }
}

void PointRenderer::loadTruth(const TaskGroup& group) {
  truth_ = store_.truth(group.truth_key, [&] { return drawnTruth(group.truth().shot, group.truth().cost); });
  held_against_ = truthPictureOf(experiment_, *truth_);
  if (group.full)
    held_against_.full =
        lab::colorOf(*store_.truth(group.full_key, [&] { return drawnTruth(*group.full, group.truth().cost); }));
  truth_key_ = group.truth_key + group.full_key;
}

void PointRenderer::warnOnce(const std::string& who, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings)
    if (warned_.insert(warning).second) warn(who + ": " + warning);
}

// What a picture is held against: truth, its own at the benign value, what is in front of what it knows.
Sight PointRenderer::sightOf(const TaskGroup& group, const Task& task, const lab::Picture& picture) {
  Sight sight;
  sight.role = task.arm->role;
  sight.truth = &held_against_;
  sight.picture = &picture;
  sight.color = lab::colorOf(picture);
  sight.bytes = plan::bytesAliased(*batch_.planOf(task.shot));
  if (std::optional<Group> benign = benignOf(experiment_, *group.group); benign && task.compares) {
    bool is_truth = task.arm->role == Role::truth;
    lab::Shot shot = is_truth ? truthShotOf(experiment_, *benign) : shotOf(experiment_, *benign, *task.arm);
    auto truth = [&] {
      return store_.truth(truthKeyOf(experiment_, batch_, shot), [&] { return drawnTruth(shot, task.cost); });
    };
    benign_ = is_truth ? lab::colorOf(*truth()) : lab::colorOf(*batch_.picture(shot));
    sight.benign = &benign_;
  }
  const std::optional<Background>& background = experiment_.background;
  if (!background || background->arm != task.arm->name) return sight;
  for (const std::string& output : {background->color, background->valid})
    if (!picture.frame.outputs.count(output))
      throw Error(fmt::format("arm '{}' has no output '{}', which the background names", task.arm->name, output),
                  {experiment_.file});
  sight.background = &*background;
  for (const Arm& arm : experiment_.arms)
    if (arm.name == background->front) {
      front_ = lab::colorOf(*batch_.picture(shotOf(experiment_, *group.group, arm)));
      sight.front = &front_;
    }
  return sight;
}

Point PointRenderer::measuredPoint(const TaskGroup& group, const Task& task) {
  prepareTruth(group);
  std::shared_ptr<const lab::Picture> picture = task.arm->role == Role::truth ? truth_ : drawn(task.shot, task.cost);
  Sight sight = sightOf(group, task, *picture);
  Point point;
  point.values = measured(sight, task.measures, experiment_.regions);
  point.limits = limitsMet(*picture);
  point.image = picture->record["outputs"]["color"];
  if (experiment_.truth_error > 0 && task.arm->role == Role::truth) {
    lab::Shot shot = task.shot;
    for (const auto& [name, value] : picture->record["shot"]["set"].items())
      lab::putSetting(shot.sets, name, plan::valueFromJson(value));
    point.command = commandOf(experiment_.shots[group.group->shot], shot);
  }
  const StudiedShot& studied = experiment_.shots[group.group->shot];
  std::string at = describe(experiment_, *group.group);
  warnOnce(fmt::format("{}{}, {}", studied.title, at.empty() ? "" : ", " + at, task.arm->name), picture->warnings);
  if (pictures_) write(group, task, *picture, point);
  return point;
}

// The EXR holds colour and what tables are made from; the record has the hash of every output.
void PointRenderer::write(const TaskGroup& group, const Task& task, const lab::Picture& picture, Point& point) {
  const StudiedShot& studied = experiment_.shots[group.group->shot];
  const Arm& arm = *task.arm;
  std::string name = fileNameOf(arm.name);
  for (const At& at : group.group->at) name += "_" + fileNameOf(experiment_.axes[at.axis].values[at.value].label);
  std::string stem = fileNameOf(studied.title) + "/" + name;
  std::set<std::string> kept = {"color", "error"};
  if (arm.role == Role::truth) kept.insert(experiment_.regions.begin(), experiment_.regions.end());
  lab::Picture written = picture;
  std::erase_if(written.frame.outputs, [&](const auto& output) { return !kept.count(output.first); });
  lab::writePicture(written, store_.folder() / (stem + ".exr"), false);
  point.measured = point.shown = stem + ".exr";
  Image shown = lab::colorOf(picture);
  if (studied.picture_aa > 1) {
    lab::Shot box = task.shot;
    box.sets = joined(box.sets, arm.box);
    box.aa = arm.box.empty() ? studied.picture_aa : 1;
    lab::Picture boxed = *batch_.picture(box, {"color"});
    shown = lab::colorOf(boxed);
    point.shown = stem + "_shown.exr";
    lab::writePicture(boxed, store_.folder() / point.shown, false);
  }
  point.record = stem + ".record.json";
  point.picture = stem + ".png";
  std::string png = image::encodePng(image::toneMap(shown, studied.tone));
  writeFileAtomically(store_.folder() / point.picture, png);
  point.picture_hash = hashText(png);
}

void PointRenderer::renderTask(const TaskGroup& group, const Task& task) {
  Point point;
  try {
    point = measuredPoint(group, task);
  } catch (const WriteError&) {
    throw;
  } catch (const Error& error) {
    point.failed = error.what();
  }
  store_.keep(task.key, point);
}

void PointRenderer::render(const TaskGroup& group, const Progress& progress) {
  progress_ = progress;
  for (const Task& task : group.tasks)
    if (!task.key.empty() && !store_.has(task.key)) renderTask(group, task);
}

}  // namespace strobe::study
