// SPDX-License-Identifier: MIT
#include "study/point_renderer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>

#include "base/hash.h"
#include "base/interruption.h"
#include "base/lists.h"
#include "base/log.h"
#include "image/draw.h"
#include "image/false_colour.h"
#include "image/metrics.h"
#include "image/png.h"
#include "lab/against_truth.h"
#include "lab/capture.h"
#include "lab/record.h"
#include "lab/shot_data.h"
#include "study/points.h"

namespace strobe::study {

using image::Image;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Adds its lifetime to `seconds`.
class Stopwatch {
 public:
  explicit Stopwatch(double& seconds) : seconds_(seconds), started_s_(clockSeconds()) {}
  Stopwatch(const Stopwatch&) = delete;
  ~Stopwatch() { seconds_ += clockSeconds() - started_s_; }

 private:
  double& seconds_;
  double started_s_;
};

// Display values, with marks on pixels that are not finite.
Image displayed(const Image& linear, const image::ToneMap& tone) {
  Image display = image::toneMap(linear, tone);
  image::markNotFinite(display, linear);
  return display;
}

void requireSize(const Image& image, const Image& picture, const std::string& what) {
  if (image::sameSize(image, picture)) return;
  throw Error(fmt::format("{} has {}x{} pixels, the picture {}x{}", what, image.width, image.height, picture.width,
                          picture.height));
}

// Rectangle of a crop in a picture of truth. A crop without coordinates has the size of the layout and lies where the
// region inner is densest.
image::Rectangle placedCrop(const Experiment& experiment, const Crop& crop, const TruthPicture& truth) {
  double scale_x = double(experiment.width) / experiment.file_width,
         scale_y = double(experiment.height) / experiment.file_height;
  if (crop) return scaledCrop(*crop, scale_x, scale_y, truth.color);
  const PicturesLayout size = experiment.layout.pictures.value_or(PicturesLayout());
  image::Rectangle scaled = scaledCrop({0, 0, size.crop_width, size.crop_height}, scale_x, scale_y, truth.color);
  auto inner = truth.masks.find("inner");
  if (inner != truth.masks.end()) return densestCrop(inner->second, scaled.width, scaled.height);
  return {(truth.color.width - scaled.width) / 2, (truth.color.height - scaled.height) / 2, scaled.width,
          scaled.height};
}

// Colour, masks, standard errors and exposures of a picture of truth.
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

}  // namespace

std::string failureOf(const std::function<void()>& step) {
  try {
    step();
  } catch (const WriteError&) {
    throw;
  } catch (const gpu::DeviceLost&) {
    throw;
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

// Advances the progress by `cost` in total.
std::shared_ptr<const lab::Picture> PointRenderer::drawn(const lab::Shot& shot, int cost) {
  int last = 0;
  Stopwatch watch(spent_.drawing_s);
  std::shared_ptr<const lab::Picture> picture = batch_.picture(shot, {}, [&](int done, int of) {
    int now = int(int64_t(cost) * done / std::max(of, 1));
    progress_(now - last);
    last = now;
  });
  progress_(cost - last);
  return picture;
}

// Truth with enough samples for the required standard error. The error falls with the square root of the samples.
std::shared_ptr<const lab::Picture> PointRenderer::drawnTruth(const lab::Shot& first, int cost) {
  lab::Shot shot = first;
  std::shared_ptr<const lab::Picture> picture = drawn(shot, cost);
  const double required = experiment_.truth_error > 0 ? experiment_.truth_error : kInfinity;
  for (double error; (error = lab::sigmaOf(*picture, {})) > required; picture = drawn(shot, 0)) {
    std::shared_ptr<const plan::PipelineDesc> pipeline = batch_.evaluate(shot.pipeline, shot.sets);
    const plan::ParamDesc* samples = plan::paramOf(*pipeline, plan::Role::SampleCount);
    if (!samples) throw Error("has no parameter that is a number of samples", {shot.pipeline});
    int64_t now = 0;
    for (const auto& [name, value] : pipeline->values)
      if (name == samples->name) now = std::get<int64_t>(value);
    double needed = std::ceil(1.1 * double(now) * std::pow(error / required, 2));
    int64_t next = int64_t(std::min(needed, samples->max.value_or(needed)));
    if (next <= now)
      throw Error(fmt::format("truth has a standard error of {:.3g} with its maximum of {} samples; required: {:.3g}",
                              error, now, required));
    lab::putSetting(shot.sets, samples->name, next);
  }
  return picture;
}

static std::vector<std::string> contentsOf(const TaskGroup& group) {
  std::vector<std::string> contents = group.truth_keys;
  contents.insert(contents.end(), group.full_keys.begin(), group.full_keys.end());
  return contents;
}

// Loads or draws the truths when a point of the group is first measured.
void PointRenderer::prepareTruth(const TaskGroup& group) {
  if (truth_keys_ == contentsOf(group)) return;
  // Do not draw a failed truth again for every arm.
  std::string& failed = failed_truths_[contentsOf(group)];
  if (failed.empty()) failed = failureOf([&] { loadTruth(group); });
  if (!failed.empty()) throw Error(failed);
}

void PointRenderer::loadTruth(const TaskGroup& group) {
  truth_keys_.clear(), truths_.clear(), held_against_.clear();
  auto kept = [&](const std::string& key, const lab::Shot& shot, size_t frames) {
    return store_.truth(key, [&] { return drawnTruth(shot, group.truth().cost / int(frames)); });
  };
  std::vector<lab::Shot> shots = sequenceOf(*group.studied, group.truth().shot), full;
  if (group.full) full = sequenceOf(*group.studied, *group.full);
  for (size_t i = 0; i < shots.size(); ++i) {
    truths_.push_back(kept(group.truth_keys[i], shots[i], shots.size()));
    held_against_.push_back(truthPictureOf(experiment_, *truths_.back()));
    if (group.full) held_against_.back().full = lab::colorOf(*kept(group.full_keys[i], full[i], shots.size()));
  }
  truth_keys_ = contentsOf(group);
}

void PointRenderer::warnOnce(const std::string& who, const std::vector<std::string>& warnings) {
  if (experiment_.is_step) return;  // no warnings for trial settings of a search
  for (const std::string& warning : warnings)
    if (warned_.insert(warning).second) warn(who + ": " + warning);
}

// Collects the references of a picture: truth, the picture at the benign value, and the foreground for its background.
MeasureInput PointRenderer::inputOf(const TaskGroup& group, const Task& task, const lab::Picture& picture,
                                    size_t frame) {
  auto atFrame = [&](const lab::Shot& shot) { return sequenceOf(*group.studied, shot)[frame]; };
  MeasureInput input;
  input.role = task.arm->role;
  input.truth = &held_against_[frame];
  input.picture = &picture;
  input.color = lab::colorOf(picture);
  requireSize(input.truth->color, input.color, "truth");
  input.bytes = plan::bytesAliased(*batch_.planOf(task.shot));
  if (std::optional<Group> benign = benignOf(experiment_, *group.group); benign && task.compares) {
    bool is_truth = task.arm->role == ArmRole::truth;
    lab::Shot shot = atFrame(is_truth ? truthShotOf(experiment_, *benign) : shotOf(experiment_, *benign, *task.arm));
    auto truth = [&] {
      return store_.truth(truthKeyOf(experiment_, batch_, shot), [&] { return drawnTruth(shot, task.cost); });
    };
    benign_ = is_truth ? lab::colorOf(*truth()) : lab::colorOf(*batch_.picture(shot));
    requireSize(benign_, input.color, "the picture at the benign value");
    input.benign = &benign_;
  }
  const std::optional<Background>& background = experiment_.background;
  if (!background || background->arm != task.arm->name) return input;
  for (const std::string& output : {background->color, background->valid}) {
    auto found = picture.frame.outputs.find(output);
    if (found == picture.frame.outputs.end())
      throw Error(fmt::format("arm '{}' has no output '{}', which the background names", task.arm->name, output),
                  {experiment_.file});
    requireSize(found->second.floats, input.color, fmt::format("output '{}', which the background names,", output));
  }
  input.background = &*background;
  for (const StudiedArm& arm : experiment_.arms)
    if (arm.name == background->front) {
      front_ = lab::colorOf(*batch_.picture(atFrame(shotOf(experiment_, *group.group, arm))));
      requireSize(front_, input.color, fmt::format("arm '{}'", arm.name));
      input.front = &front_;
    }
  return input;
}

// Mean of each value over the frames with this value.
static Values meanOf(const std::vector<Values>& frames) {
  Values sums;
  std::map<std::pair<std::string, std::string>, int> counts;
  for (const Values& values : frames)
    for (const auto& [measure, by_region] : values)
      for (const auto& [region, value] : by_region) sums[measure][region] += value, ++counts[{measure, region}];
  for (auto& [measure, by_region] : sums)
    for (auto& [region, value] : by_region) value /= counts[{measure, region}];
  return sums;
}

// The files of a sequence show its last frame.
Point PointRenderer::measuredPoint(const TaskGroup& group, const Task& task) {
  prepareTruth(group);
  std::vector<lab::Shot> shots = sequenceOf(*group.studied, task.shot);
  std::shared_ptr<const lab::Picture> picture;
  std::vector<Values> frames;
  std::optional<MeasureInput> before;
  std::string images;
  Point point;
  for (size_t i = 0; i < shots.size(); ++i) {
    picture = task.arm->role == ArmRole::truth ? truths_[i] : drawn(shots[i], task.cost / int(shots.size()));
    Stopwatch watch(spent_.measuring_s);
    MeasureInput input = inputOf(group, task, *picture, i);
    if (before) input.before = &*before;
    frames.push_back(measured(input, task.measures, experiment_.regions));
    std::string image = picture->record["outputs"]["color"];
    images += (i ? "," : "") + image;
    point.preset = picture->record["pipeline"].value("preset", "");
    for (const std::string& limit : picture->record["limits"].get<std::vector<std::string>>())
      addOnce(point.limits, limit);
    input.before = nullptr, input.picture = nullptr;
    before.emplace(std::move(input));
  }
  point.values = meanOf(frames);
  point.image = shots.size() > 1 ? hashText(images) : images;
  if (task.arm->role == ArmRole::truth) {
    point.attribution = lab::attributionOf(truths_.front()->record);
    for (const Crop& crop : group.studied->wanted_crops)
      point.crops.push_back(placedCrop(experiment_, crop, held_against_.front()));
  }
  if (experiment_.truth_error > 0 && task.arm->role == ArmRole::truth) {
    lab::Shot shot = task.shot;
    for (const auto& [name, value] : truths_.front()->record["shot"]["set"].items())
      lab::putSetting(shot.sets, name, plan::valueFromJson(value));
    point.command = commandOf(*group.studied, shot);
  }
  const std::string at = afterComma(describe(experiment_, *group.group));
  warnOnce(fmt::format("{}{}, {}", group.studied->title, at, task.arm->name), picture->warnings);
  Stopwatch watch(spent_.keeping_s);
  keepFiles(group, task, *picture, point);
  if (experiment_.layout.pictures) write(group, task, *picture, point);
  return point;
}

// Adds the hash of a file with this content to the point, by the name of the file below the folder.
void PointRenderer::noteFile(Point& point, const Path& file, const std::string& content) const {
  point.files[file.lexically_relative(store_.folder()).generic_string()] = hashText(content);
}

// Writes the picture as shown, and the linear picture if required.
void PointRenderer::keepFiles(const TaskGroup& group, const Task& task, const lab::Picture& picture, Point& point) {
  const image::ToneMap& tone = group.studied->tone;
  std::string png = image::encodePng(displayed(lab::colorOf(picture), tone), image::PngEffort::fast);
  Path file = pointFile(store_.folder(), task.key, ".png");
  // Not flushed to disk here; the JSON file of the point is written later and is flushed.
  writeFileAtomically(file, png, Flush::no);
  noteFile(point, file, png);
  if (!store_.requires_exr) return;
  for (const Path& linear : lab::writePicture(picture, pointFile(store_.folder(), task.key, ".exr")))
    noteFile(point, linear, readText(linear));
}

// Writes the files of the layout. The EXR has `color`, `error` and, for truth, masks; the record has the hash of every
// output.
void PointRenderer::write(const TaskGroup& group, const Task& task, const lab::Picture& picture, Point& point) {
  const StudiedShot& studied = *group.studied;
  const StudiedArm& arm = *task.arm;
  std::string name = lab::fileNameOf(arm.name);
  for (const At& at : group.group->at) name += "_" + lab::fileNameOf(experiment_.axes[at.axis].labels[at.value]);
  std::string stem = lab::fileNameOf(studied.title) + "/" + name;
  std::set<std::string> kept = {"color", "error"};
  if (arm.role == ArmRole::truth) kept.insert(experiment_.regions.begin(), experiment_.regions.end());
  lab::Picture written = picture;
  std::erase_if(written.frame.outputs, [&](const auto& output) { return !kept.count(output.first); });
  lab::writePicture(written, store_.folder() / (stem + ".exr"));
  point.measured = point.shown = stem + ".exr";
  Image shown = lab::colorOf(picture);
  if (studied.picture_aa > 1) {
    lab::Shot box = task.shot;
    box.sets = joined(box.sets, arm.box);
    box.aa = arm.box.empty() ? studied.picture_aa : 1;
    lab::Picture boxed = *batch_.picture(box, {"color"});
    shown = lab::colorOf(boxed);
    point.shown = stem + "_shown.exr";
    lab::writePicture(boxed, store_.folder() / point.shown);
  }
  point.record = stem + ".record.json";
  point.picture = stem + ".png";
  image::writePng(store_.folder() / point.picture, displayed(shown, studied.tone));
  for (const std::string& file : {point.measured, point.shown, point.record, point.picture})
    noteFile(point, store_.folder() / file, readText(store_.folder() / file));
}

// Draws, measures and stores one point. A lost device ends the run and leaves the point not drawn.
void PointRenderer::renderTask(const TaskGroup& group, const Task& task) {
  const std::string at = afterComma(describe(experiment_, *group.group));
  const std::string name = fmt::format("{}{}, {}", group.studied->name, at, task.arm->name);
  batch_.bench().device().setSubject(name);
  worker_.begin(name);
  Point point;
  const std::string failed = failureOf([&] { point = measuredPoint(group, task); });
  if (!failed.empty()) {
    point.failed = failed;
    point.tries = store_.point(task.key).value_or(Point()).tries;
    point.tries.push_back(failed);
    warn(fmt::format("{}: failed: {}", name, failed));
  }
  const gpu::DeviceInfo& device = batch_.bench().device().info();
  point.device = device.name, point.driver = device.driver;
  store_.keep(task.key, point);
  if (point.isDrawn() && !task.timed) store_.finish(task.key);
  cost_ += task.cost;
  points_ += task.arm->role != ArmRole::truth;
  worker_.reach(points_, spent_.sum());
}

// False as soon as this or another program has drawn the result, or failed to draw it.
bool PointRenderer::isMissing(const Task& task) {
  auto missing = missing_.find(task.key);
  if (missing == missing_.end()) return false;
  if (!store_.has(task.key) && store_.triesOf(task.key) == missing->second) return true;
  missing_.erase(missing);
  progress_(task.cost);
  return false;
}

bool PointRenderer::render(const TaskGroup& group, const Progress& progress) {
  progress_ = progress;
  for (const Task& task : group.tasks) {
    if (!isMissing(task)) continue;
    stopIfRequested();
    if (cost_ > 0) stopIfLonger(spent_.sum() * task.cost / cost_);
    const std::unique_ptr<Lease> claim = store_.claim(task.key);
    if (!claim) return false;
    if (!isMissing(task)) continue;  // drawn between the look and the claim
    renderTask(group, task);
    missing_.erase(task.key);
  }
  batch_.bench().device().setSubject("");
  return true;
}

}  // namespace strobe::study
