// SPDX-License-Identifier: MIT
#include "lab/exhibit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "base/log.h"
#include "image/metrics.h"
#include "image/png.h"
#include "lab/against_truth.h"
#include "lab/capture.h"
#include "lab/pace.h"
#include "math/statistics.h"

namespace strobe::lab {

namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr int kFrameCost = 12;  // of one frame of a method, in time samples of truth

// Time samples of a pipeline's loops; 0 without loops.
int loopCost(const Home& home, const DemoColumn& column, const script::Settings& sets) {
  plan::PipelineDesc pipeline = script::evaluatePipeline(home, {column.pipeline, sets});
  int64_t cost = 0;
  for (const plan::LoopDesc& loop : pipeline.loops) {
    if (loop.count.value) cost += std::get<int64_t>(*loop.count.value);
    for (const auto& [name, value] : pipeline.values)
      if (name == loop.count.follows) cost += std::get<int64_t>(value);
  }
  return int(cost);
}

// ---- what is rendered

// A picture still to be rendered: a column in an anchor of a shot.
struct Task {
  const DemoColumn* column;
  std::string anchor;
  script::Settings sets;
  int runs = 1;  // frames without the one to warm up
  int frame_cost = 0;
  bool warms_up = true;

  int cost() const { return frame_cost * (runs + (warms_up ? 1 : 0)); }
};

bool isTruth(const DemoColumn& column) { return column.role == DemoColumn::Role::truth; }

Task taskOf(const Home& home, const DemoShot& shot, const DemoColumn& column, const std::string& anchor) {
  Task task{&column, anchor, joined(shot.shot.sets, column.sets)};
  if (isTruth(column)) task.sets = joined(task.sets, shot.truth);
  int samples = loopCost(home, column, task.sets);
  task.frame_cost = samples > 0 ? samples : kFrameCost;
  task.warms_up = samples == 0;
  int pictures = shot.shot.aa > 1 ? (isTruth(column) ? 1 : shot.shot.aa) : 0;
  task.runs = 1 + pictures + (isTruth(column) && shot.full_shading ? 1 : 0);
  return task;
}

// The shot's own anchor, then those that columns want besides.
std::vector<std::string> anchorsOf(const Demo& demo, const DemoShot& shot) {
  std::vector<std::string> anchors = {shot.shot.anchor};
  for (const DemoColumn& column : demo.columns)
    if (!column.own_anchor.empty() && std::find(anchors.begin(), anchors.end(), column.own_anchor) == anchors.end())
      anchors.push_back(column.own_anchor);
  return anchors;
}

// In an anchor that is not the shot's: columns that want it, truth and the floor.
bool belongs(const DemoColumn& column, const std::string& anchor, const DemoShot& shot) {
  return anchor == shot.shot.anchor || column.own_anchor == anchor || column.role != DemoColumn::Role::method;
}

std::vector<Task> tasksOf(const Home& home, const Demo& demo, const DemoShot& shot) {
  std::vector<Task> tasks;
  if (!shot.missing.empty()) return tasks;
  for (const std::string& anchor : anchorsOf(demo, shot))
    for (const DemoColumn& column : demo.columns)
      if (belongs(column, anchor, shot)) tasks.push_back(taskOf(home, shot, column, anchor));
  return tasks;
}

// ---- what is measured

// Median of |velocity| over the pixels of instances that move by half a pixel anywhere in the picture.
double medianDisplacement(const Picture& truth) {
  auto velocity = truth.frame.outputs.find("velocity"), id = truth.frame.outputs.find("id");
  if (velocity == truth.frame.outputs.end() || id == truth.frame.outputs.end()) return kNothing;
  const image::Image& v = velocity->second.floats;
  const image::UintImage& ids = id->second.uints;
  auto length = [&](int x, int y) { return std::hypot(double(v.at(x, y, 0)), double(v.at(x, y, 1))); };
  std::set<uint32_t> moving;
  for (int y = 0; y < v.height; ++y)
    for (int x = 0; x < v.width; ++x)
      if (length(x, y) >= 0.5) moving.insert(ids.at(x, y, 0));
  std::vector<double> lengths;
  for (int y = 0; y < v.height; ++y)
    for (int x = 0; x < v.width; ++x)
      if (moving.count(ids.at(x, y, 0))) lengths.push_back(length(x, y));
  return lengths.empty() ? 0 : median(std::move(lengths));
}

// What a scene's file says of its author: its copyright, else the first line of the text beside it.
std::string attributionOf(const Json& scene) {
  if (!scene.contains("attribution") || !scene["attribution"].is_object()) return "";
  const Json& said = scene["attribution"];
  if (said.contains("copyright") && said["copyright"].is_string()) return said["copyright"].get<std::string>();
  std::string text = said.contains("text") && said["text"].is_string() ? said["text"].get<std::string>() : "";
  return text.substr(0, text.find('\n'));
}

Contrast contrastOf(const image::Image& front, const image::Image& back, const image::Image& valid,
                    const image::Image& inner) {
  Contrast contrast;
  std::array<double, 3> sum{}, squares{};
  double difference = 0;
  for (int y = 0; y < front.height; ++y)
    for (int x = 0; x < front.width; ++x) {
      if (valid.at(x, y, 0) < 0.5f || inner.at(x, y, 0) < 0.5f) continue;
      ++contrast.pixels;
      for (int c = 0; c < 3; ++c) {
        double b = back.at(x, y, c);
        sum[size_t(c)] += b;
        squares[size_t(c)] += b * b;
        difference += std::abs(front.at(x, y, c) - b);
      }
    }
  if (contrast.pixels == 0) return contrast;
  double n = double(contrast.pixels), variance = 0;
  for (size_t c = 0; c < 3; ++c) variance += std::max(0.0, squares[c] / n - sum[c] / n * (sum[c] / n));
  contrast.deviation = std::sqrt(variance / 3);
  contrast.difference = difference / (3 * n);
  return contrast;
}

// Where most of a mask lies: the best place for a window of this size.
image::Rectangle densest(const image::Image& mask, int width, int height) {
  int w = mask.width, h = mask.height;
  std::vector<int64_t> sums(size_t(w + 1) * size_t(h + 1), 0);
  auto sum = [&](int x, int y) -> int64_t& { return sums[size_t(y) * size_t(w + 1) + size_t(x)]; };
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x)
      sum(x + 1, y + 1) = (mask.at(x, y, 0) >= 0.5f) + sum(x, y + 1) + sum(x + 1, y) - sum(x, y);
  image::Rectangle best{(w - width) / 2, (h - height) / 2, width, height};
  int64_t most = 0;
  double least = 0;
  for (int y = 0; y + height <= h; ++y)
    for (int x = 0; x + width <= w; ++x) {
      int64_t inside = sum(x + width, y + height) - sum(x, y + height) - sum(x + width, y) + sum(x, y);
      // Of equally dense places the one whose middle is fullest.
      int qx = width / 4, qy = height / 4;
      double middle = double(sum(x + width - qx, y + height - qy) - sum(x + qx, y + height - qy) -
                             sum(x + width - qx, y + qy) + sum(x + qx, y + qy));
      if (inside < most || (inside == most && middle <= least)) continue;
      most = inside, least = middle, best = {x, y, width, height};
    }
  return best;
}

// ---- one run

class Hall {
 public:
  Hall(const Demo& demo, Workbench& bench, const Path& folder, double scale_x, double scale_y, Pace& pace)
      : demo_(demo), bench_(bench), folder_(folder), scale_x_(scale_x), scale_y_(scale_y), pace_(pace) {}

  ShotResult hang(const DemoShot& shot);

 private:
  Picture frame(const DemoShot& shot, const Task& task, const script::Settings& more, int aa, bool counted);
  Entry entryOf(const DemoShot& shot, const Task& task, Picture& picture);
  Group groupOf(ShotResult& result, const DemoShot& shot, const std::string& anchor);
  void describe(ShotResult& result, const Picture& truth);
  void measure(const Group& group, const Entry& truth, const std::map<std::string, double>& sigma,
               const image::Image& full, Entry& entry) const;
  void keepBackground(const Picture& picture);
  void write(const DemoShot& shot, const Task& task, Picture& picture, Entry& entry) const;
  image::Rectangle placed(const DemoCrop& crop, const Group& group) const;
  std::optional<Contrast> contrast(const Group& group) const;
  std::optional<Verdict> verdict(const ShotResult& result) const;

  const Demo& demo_;
  Workbench& bench_;
  Path folder_;
  double scale_x_, scale_y_;
  Pace& pace_;
  image::Image back_, back_valid_;  // of the shot at hand
  std::set<std::string> told_;      // warnings
};

Picture Hall::frame(const DemoShot& shot, const Task& task, const script::Settings& more, int aa, bool counted) {
  Shot wanted = shot.shot;
  wanted.pipeline = task.column->pipeline;
  wanted.sets = joined(task.sets, more);
  wanted.anchor = task.anchor;
  wanted.aa = aa;
  int last = 0, cost = counted ? task.frame_cost * aa : 0;
  Picture picture = bench_.render(wanted, [&](int done, int of) {
    int now = int(int64_t(cost) * done / std::max(of, 1));
    pace_.advance(now - last);
    last = now;
  });
  pace_.advance(cost - last);
  return picture;
}

// The first frame of a pipeline pays for compiling it, so the second one is timed.
Entry Hall::entryOf(const DemoShot& shot, const Task& task, Picture& picture) {
  Entry entry;
  entry.column = task.column;
  bool timed = task.warms_up || !task.column->warm.empty();
  if (timed) frame(shot, task, task.column->warm, 1, task.warms_up);
  picture = frame(shot, task, {}, 1, true);
  if (timed) entry.ms = picture.frame.gpu_ms;
  entry.clamped = clampedPixels(picture.record);
  for (const std::string& warning : picture.warnings)
    if (told_.insert(warning).second) warn(fmt::format("{}, {}: {}", shot.title, task.column->label, warning));
  entry.color = colorOf(picture);
  entry.shown = entry.color;
  if (shot.shot.aa > 1) {
    bool box = !task.column->box.empty();
    entry.shown = colorOf(frame(shot, task, task.column->box, box ? 1 : shot.shot.aa, true));
  }
  entry.record = picture.record;
  entry.timings = picture.timings;
  write(shot, task, picture, entry);
  pace_.finish(fmt::format("{}: {}{}", shot.title, task.column->label,
                           task.anchor == shot.shot.anchor ? "" : " (" + task.anchor + ")"));
  return entry;
}

// The EXR holds colour and what tables are made from; the record has the hash of every output.
void Hall::write(const DemoShot& shot, const Task& task, Picture& picture, Entry& entry) const {
  std::string name = fileNameOf(task.column->label);
  if (task.anchor != shot.shot.anchor) name += "_" + task.anchor;
  Path stem = folder_ / fileNameOf(shot.title) / name;
  Picture written = picture;
  std::set<std::string> wanted = {"color", "error"};
  if (isTruth(*task.column)) wanted.insert(demo_.regions.begin(), demo_.regions.end());
  std::erase_if(written.frame.outputs, [&](const auto& output) { return !wanted.count(output.first); });
  entry.files = writePicture(written, stem.string() + ".exr", false);
  entry.files.push_back(stem.string() + ".png");
  image::writePng(entry.files.back(), image::toneMap(entry.shown, shot.tone));
}

void Hall::measure(const Group& group, const Entry& truth, const std::map<std::string, double>& sigma,
                   const image::Image& full, Entry& entry) const {
  bool is_truth = isTruth(*entry.column), floor = entry.column->role == DemoColumn::Role::floor;
  image::Image flip, hdr;
  if (demo_.measures.count("flip")) flip = image::ldrFlip(entry.color, truth.color);
  image::HdrFlipOptions options;
  options.exposures = group.exposures;
  if (demo_.measures.count("hdr_flip")) hdr = image::hdrFlip(entry.color, truth.color, options).map;
  for (const std::string& region : demo_.regions) {
    const image::Image& mask = group.masks.at(region);
    double mse = image::meanSquaredError(entry.color, truth.color, mask), own = sigma.at(region);
    Errors& errors = entry.errors[region];
    errors.rmse = is_truth ? own : std::sqrt(mse + (floor ? own * own : 0));
    errors.flip = flip.empty() ? kNothing : image::meanOf(flip, mask);
    errors.hdr_flip = hdr.empty() ? kNothing : image::meanOf(hdr, mask);
    errors.full_rmse = full.empty() ? kNothing : image::rootMeanSquaredError(entry.color, full, mask);
  }
}

// Size, exposure and the like as the scene supplied them, from the record of a picture.
void Hall::describe(ShotResult& result, const Picture& truth) {
  const Json& shot = truth.record["shot"];
  result.resolved = result.shot->shot;
  result.resolved.fps = shot["fps"].get<double>();
  result.resolved.frame = shot["frame"].get<int>();
  result.resolved.exposure = shot["exposure"].get<double>();
  result.displacement_px = medianDisplacement(truth);
  result.attribution = result.shot->attribution;
  if (result.attribution.empty()) result.attribution = attributionOf(truth.record["scene"]);
}

void Hall::keepBackground(const Picture& picture) {
  auto output = [&](const std::string& name) {
    auto found = picture.frame.outputs.find(name);
    if (found == picture.frame.outputs.end())
      throw Error(fmt::format("column '{}' has no output '{}', which the demo's background names",
                              demo_.background->column, name));
    return found->second.floats;
  };
  back_ = threeChannels(output(demo_.background->color));
  back_valid_ = output(demo_.background->valid);
}

Group Hall::groupOf(ShotResult& result, const DemoShot& shot, const std::string& anchor) {
  Group group;
  group.anchor = anchor;
  Picture truth;
  Task truth_task = taskOf(bench_.home(), shot, demo_.truth(), anchor);
  Entry reference = entryOf(shot, truth_task, truth);
  if (!result.resolved.fps) describe(result, truth);
  image::Image full;
  if (shot.full_shading) full = colorOf(frame(shot, truth_task, *shot.full_shading, 1, true));
  std::map<std::string, double> sigma;
  for (const std::string& region : demo_.regions) {
    image::Image mask = maskOf(truth, region);
    group.pixels[region] = image::countedPixels(reference.color, mask);
    sigma[region] = sigmaOf(truth, mask);
    group.masks[region] = std::move(mask);
  }
  group.exposures = image::automaticExposures(reference.color, reference.color);
  for (const DemoColumn& column : demo_.columns) {
    if (!belongs(column, anchor, shot)) continue;
    Picture picture;
    Entry entry = isTruth(column) ? reference : entryOf(shot, taskOf(bench_.home(), shot, column, anchor), picture);
    measure(group, reference, sigma, full, entry);
    if (demo_.background && demo_.background->column == column.label && result.groups.empty())
      keepBackground(isTruth(column) ? truth : picture);
    group.entries.push_back(std::move(entry));
  }
  return group;
}

image::Rectangle Hall::placed(const DemoCrop& crop, const Group& group) const {
  const image::Image& picture = group.truth().color;
  auto scaled = [](int value, double scale, int most) { return std::clamp(int(std::lround(value * scale)), 1, most); };
  if (crop) {
    int width = scaled(crop->width, scale_x_, picture.width), height = scaled(crop->height, scale_y_, picture.height);
    return {std::clamp(int(crop->x * scale_x_), 0, picture.width - width),
            std::clamp(int(crop->y * scale_y_), 0, picture.height - height), width, height};
  }
  int width = scaled(demo_.crop_width, scale_x_, picture.width),
      height = scaled(demo_.crop_height, scale_y_, picture.height);
  auto inner = group.masks.find("inner");
  if (inner == group.masks.end()) return {(picture.width - width) / 2, (picture.height - height) / 2, width, height};
  return densest(inner->second, width, height);
}

std::optional<Contrast> Hall::contrast(const Group& group) const {
  auto inner = group.masks.find("inner");
  if (!demo_.background || back_.empty() || inner == group.masks.end()) return std::nullopt;
  return contrastOf(group.find(demo_.background->front)->color, back_, back_valid_, inner->second);
}

std::optional<Verdict> Hall::verdict(const ShotResult& result) const {
  const Group& group = result.groups.front();
  if (!demo_.expectation || !group.floor() || !result.contrast) return std::nullopt;
  const DemoExpectation& e = *demo_.expectation;
  auto rmse = [&](const Entry& entry) { return entry.errors.at(e.region).rmse; };
  double own = rmse(*group.find(e.column)), floor = rmse(*group.floor()), best_baseline = INFINITY;
  for (const std::string& name : e.baselines) best_baseline = std::min(best_baseline, rmse(*group.find(name)));
  if (result.contrast->pixels == 0) return std::nullopt;
  double contrast = result.contrast->deviation / result.contrast->difference;
  // No claim rests on displacements that were shortened.
  uint64_t clamped = group.find(e.column)->clamped;
  for (const std::string& name : e.baselines) clamped += group.find(name)->clamped;
  Verdict verdict;
  verdict.applies = contrast >= e.contrast && clamped == 0;
  verdict.holds = own <= e.share * best_baseline && own <= e.floor * floor;
  verdict.text = fmt::format(
      "{}, {}: RMSE {:.5f} is {:.3f} of the best baseline's (expected at most {:.3g}) and {:.2f} of the floor's "
      "(at most {:.3g}); the background deviates by {:.2f} of its difference from the front ({} {:.3g}); {} pixels "
      "clamped: {}",
      e.column, e.region, own, own / best_baseline, e.share, own / floor, e.floor, contrast,
      contrast >= e.contrast ? "at least" : "less than", e.contrast, clamped,
      !verdict.applies ? "does not apply"
      : verdict.holds  ? "holds"
                       : "does not hold");
  return verdict;
}

ShotResult Hall::hang(const DemoShot& shot) {
  ShotResult result;
  result.shot = &shot;
  result.resolved.fps = 0;
  if (!shot.missing.empty()) {
    note(fmt::format("{}: skipped, {}", shot.title, shot.missing));
    return result;
  }
  back_ = back_valid_ = {};
  for (const std::string& anchor : anchorsOf(demo_, shot)) result.groups.push_back(groupOf(result, shot, anchor));
  for (const DemoCrop& crop : shot.crops) result.crops.push_back(placed(crop, result.groups.front()));
  result.contrast = contrast(result.groups.front());
  result.verdict = verdict(result);
  return result;
}

}  // namespace

const Entry* Group::find(const std::string& label) const {
  for (const Entry& entry : entries)
    if (entry.column->label == label) return &entry;
  return nullptr;
}

const Entry& Group::truth() const {
  for (const Entry& entry : entries)
    if (isTruth(*entry.column)) return entry;
  STROBE_ASSERT(false, "a group without truth");
  std::abort();
}

const Entry* Group::floor() const {
  for (const Entry& entry : entries)
    if (entry.column->role == DemoColumn::Role::floor) return &entry;
  return nullptr;
}

Exhibition exhibit(const Demo& demo, Workbench& bench, const Path& folder, int file_width, int file_height) {
  Exhibition result;
  result.demo = &demo;
  result.device = bench.device().info();
  int pictures = 0, cost = 0;
  for (const DemoShot& shot : demo.shots)
    for (const Task& task : tasksOf(bench.home(), demo, shot)) ++pictures, cost += task.cost();
  double started_s = clockSeconds();
  Pace pace("demo", pictures, cost);
  for (const DemoShot& shot : demo.shots) {
    Hall hall(demo, bench, folder, double(demo.width) / file_width, double(demo.height) / file_height, pace);
    result.shots.push_back(hall.hang(shot));
  }
  result.render_s = clockSeconds() - started_s;
  return result;
}

}  // namespace strobe::lab
