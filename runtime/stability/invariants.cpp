// SPDX-License-Identifier: MIT
#include "stability/invariants.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "base/hash.h"
#include "image/metrics.h"
#include "image/regions.h"
#include "plan/named.h"
#include "stability/box_filter.h"
#include "stability/pictures.h"

namespace strobe::stability {

using plan::Role;

Random CheckedCase::draw(const char* what) const { return Random(uint64_t(knob(shot, "seed", 1)), what); }

lab::Shot CheckedCase::sharp(const lab::Shot& shot) const {
  return by(shot, batch.nameOf(plan::PipelineDesc::Kind::Sharp));
}

lab::Shot CheckedCase::truth(const lab::Shot& shot, int samples) const {
  auto pipeline = batch.evaluate(batch.nameOf(plan::PipelineDesc::Kind::Truth), {});
  return with(by(shot, pipeline->name), *pipeline, Role::SampleCount, samples);
}

bool blurs(lab::Batch& batch, const lab::Shot& shot) {
  lab::Shot sharp = by(shot, batch.nameOf(plan::PipelineDesc::Kind::Sharp));
  return image::rootMeanSquaredError(*batch.color(shot), *batch.color(sharp)) > 1e-3;
}

namespace {

ExposureInterval windowOf(const lab::Shot& shot) {
  if (shot.anchor == "centre") return {-.5, .5};
  return shot.anchor == "start" ? ExposureInterval{0, 1} : ExposureInterval{-1, 0};
}

lab::Shot without(lab::Shot shot, std::initializer_list<const char*> knobs) {
  for (const char* name : knobs) shot = with(shot, std::string("scene.") + name, 0);
  return shot;
}

// Changes the size; keeps the maximum displacement in pixels.
lab::Shot resized(const CheckedCase& subject, const lab::Shot& shot, int width, int height) {
  lab::Shot result = sized(shot, width, height);
  const plan::ParamDesc* reach = plan::paramOf(subject.pipeline, Role::Reach);
  if (!reach) return result;
  double limit = numberOf(subject.pipeline, reach->name, 0);
  for (const auto& [name, value] : shot.sets)
    if (name == reach->name) limit = std::stod(plan::textOf(plan::checkValue(*reach, value, {})));
  return limit < 0 ? result : with(result, reach->name, limit * shot.width / width);
}

std::shared_ptr<const plan::PipelineDesc> evaluated(const CheckedCase& subject, const lab::Shot& shot) {
  return subject.batch.evaluate(shot.pipeline, shot.sets);
}

int roundedUp(int value, int step) { return (value + step - 1) / step * step; }

Finding none() {
  Finding finding;
  finding.applies = false;
  return finding;
}

Finding worse(const Finding& a, const Finding& b) {
  if (a.holds != b.holds) return a.holds ? b : a;
  return b.excess > a.excess ? b : a;
}

// ---- constant

Finding constant(const CheckedCase& subject) {
  Random draw = subject.draw("constant");
  const double values[] = {.7, 1.0 / 3, 6e4, 1e-20, 1e-40, 1e6};  // the sky's maximum is 1e6
  float value = float(values[draw.whole(0, 5)]);
  lab::Shot shot = with(subject.shot, "scene.value", value);
  double samples = std::max(subject.samples(), 1.0);
  // Subnormal numbers may be flushed to 0.
  double ulp = std::max<double>(std::nextafter(value, std::numeric_limits<float>::infinity()) - value, 0);
  double tolerance = value < 1e-30f ? 1e-7 * 1e-30 : 2 * ulp * samples;
  return compare(*subject.batch.color(shot), [&](int, int, int) { return exactly(value, tolerance); }, {shot});
}

// ---- still, brief

Finding same(const CheckedCase& subject, const lab::Shot& shot, const lab::Shot& right, double tolerance) {
  Picture picture = subject.batch.color(shot), wanted = subject.batch.color(right);
  auto at = [&](int x, int y, int c) { return exactly(wanted->at(x, y, c), tolerance); };
  return compare(*picture, at, {shot, right});
}

Finding still(const CheckedCase& subject) {
  lab::Shot at_rest = with(subject.shot, "scene.speed", 0);
  lab::Shot closed = subject.shot;
  closed.exposure = 0;
  return worse(same(subject, at_rest, subject.sharp(at_rest), 0), same(subject, closed, subject.sharp(closed), 0));
}

// Smallest and largest value around a pixel, in all pictures.
std::optional<Right> rangeAround(const std::vector<Picture>& pictures, int x, int y, int c, int radius,
                                 double tolerance) {
  Right right{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), tolerance};
  for (const Picture& picture : pictures)
    for (int v = std::max(y - radius, 0); v <= std::min(y + radius, picture->height - 1); ++v)
      for (int u = std::max(x - radius, 0); u <= std::min(x + radius, picture->width - 1); ++u) {
        right.low = std::min<double>(right.low, picture->at(u, v, c));
        right.high = std::max<double>(right.high, picture->at(u, v, c));
      }
  return right;
}

Finding brief(const CheckedCase& subject) {
  lab::Shot shot = without(subject.shot, {"lit", "boxes", "balls", "spin"});
  // A pipeline with loops draws other times too. A gap between two cards, narrower than a pixel, may then show a
  // surface that no pixel centre of the sharp picture shows.
  if (!subject.pipeline.loops.empty()) shot = with(shot, "scene.cards", 1);
  double reach = knob(shot, "reach", 10);
  lab::Shot hardly = shot, little = shot;
  hardly.exposure = shot.exposure * (1.0 / 16) / reach;
  little.exposure = shot.exposure * .4 / reach;
  lab::Shot sharp = subject.sharp(shot);
  Picture right = subject.batch.color(sharp), picture = subject.batch.color(little);
  auto around = [&](int x, int y, int c) { return rangeAround({right}, x, y, c, 1, 1e-5); };
  return worse(same(subject, hardly, sharp, 1e-5), compare(*picture, around, {little, sharp}));
}

// ---- mirrored, shifted, reversed

Finding mirrored(const CheckedCase& subject) {
  Random draw = subject.draw("mirrored");
  lab::Shot shot = without(subject.shot, {"balls", "spin"});
  int sides = draw.whole(0, 3);
  // Pipelines with loops draw silhouettes at other times; ties would put these silhouettes on pixel centres.
  bool ties = draw.chance(.4) && subject.pipeline.loops.empty();
  if (ties) {
    shot = with(with(resized(subject, shot, 64, 32), "scene.ties", 1), "scene.perspective", 0);
    shot = with(with(shot, "scene.lit", 0), "scene.boxes", 0);
    shot = with(shot, subject.pipeline, Role::Tile, 8);
    // An odd number of samples has one at half of the displacement: exactly between two pixels if the displacement is
    // odd.
    if (const auto* samples = plan::paramOf(subject.pipeline, Role::SampleCount))
      shot = with(shot, samples->name, draw.chance(.5) ? 1 : 3);
  }
  int grid = gridOf(*evaluated(subject, shot));
  bool turn = sides == 3;
  int width = roundedUp(shot.width, grid), height = roundedUp(shot.height, grid);
  if (turn) width = height = ties ? 64 : std::max(width, height);
  shot = resized(subject, shot, width, height);
  lab::Shot other = shot;
  if (sides != 1) other = with(other, "scene.mirror", -1);
  if (sides == 1 || sides == 2) other = with(other, "scene.flip", -1);
  if (turn) other = with(other, "scene.turn", 1);

  Picture one = subject.batch.color(shot), two = subject.batch.color(other);
  double tolerance = 1e-5 * std::max(1.0, image::largestColour(*one));
  auto at = [&](int x, int y, int c) {
    if (sides != 1) x = width - 1 - x;
    if (sides == 1 || sides == 2) y = height - 1 - y;
    return exactly(turn ? two->at(y, width - 1 - x, c) : two->at(x, y, c), tolerance);
  };
  return compare(*one, at, {shot, other});
}

Finding shifted(const CheckedCase& subject) {
  Random draw = subject.draw("shifted");
  lab::Shot shot = with(without(subject.shot, {"perspective", "lit", "boxes", "balls", "spin"}), "scene.wall", 1);
  if (const auto* tile = plan::paramOf(subject.pipeline, Role::Tile))
    shot = with(shot, tile->name, draw.whole(0, 1) ? 8 : 4);
  int grid = gridOf(*evaluated(subject, shot));
  bool any = grid == 1;
  int by_x = (any ? 5 : grid) * (draw.chance(.5) ? 1 : -1), by_y = (any ? 3 : grid) * draw.whole(-1, 1);
  int room = std::max(std::abs(by_x), std::abs(by_y)) + 1;
  int margin = 9;                          // a sample outside one picture may be inside the other
  shot = resized(subject, shot, 128, 64);  // powers of two, so that positions in the picture are exact
  shot = with(with(shot, "scene.inside", room), "scene.reach", std::min(knob(shot, "reach", 10), margin - 1.0));
  lab::Shot other = with(with(shot, "scene.shift_x", by_x), "scene.shift_y", by_y);
  Picture one = subject.batch.color(shot), two = subject.batch.color(other);
  auto is_inner = [&](int x, int y) {
    return x >= margin && y >= margin && x < one->width - margin && y < one->height - margin;
  };
  auto at = [&](int x, int y, int c) -> std::optional<Right> {
    int u = x + by_x, v = y + by_y;
    if (!is_inner(x, y) || !is_inner(u, v)) return std::nullopt;
    return exactly(two->at(u, v, c), 0);
  };
  return compare(*one, at, {shot, other});
}

Finding reversed(const CheckedCase& subject) {
  lab::Shot shot = subject.shot, other = with(subject.shot, "scene.speed", -1);
  other.anchor = shot.anchor == "end" ? "start" : shot.anchor == "start" ? "end" : "centre";
  Picture right = subject.batch.color(other);
  return same(subject, shot, other, 1e-5 * std::max(1.0, image::largestColour(*right)));
}

// ---- convex, uniform

Finding convex(const CheckedCase& subject) {
  lab::Shot shot = without(subject.shot, {"lit"});
  lab::Shot layer = subject.sharp(shot);
  std::vector<Picture> layers;
  int objects = 1 + int(knob(shot, "cards", 5) + knob(shot, "boxes", 0) + knob(shot, "balls", 0));
  for (int peel = 0; peel <= objects; ++peel) layers.push_back(subject.batch.color(with(layer, "scene.peel", peel)));
  int radius = int(std::ceil(knob(shot, "reach", 10))) + 3;
  double tolerance = 1e-5 * std::max(1.0, image::largestColour(*layers.front()));
  // A pipeline with loops shows surfaces that enter the picture from outside of the layers.
  int border = subject.pipeline.loops.empty() ? 0 : radius;
  const Picture& around = layers.front();
  auto at = [&](int x, int y, int c) -> std::optional<Right> {
    bool inside = std::min(x, y) >= border && x + border < around->width && y + border < around->height;
    return inside ? rangeAround(layers, x, y, c, radius, tolerance) : std::nullopt;
  };
  return compare(*subject.batch.color(shot), at, {shot});
}

Finding uniform(const CheckedCase& subject) {
  Random draw = subject.draw("uniform");
  lab::Shot shot = with(without(subject.shot, {"perspective", "lit", "speed", "spin"}), "scene.wall", 1);
  double reach = knob(shot, "reach", 10), angle = draw.unit() * 6.283185307;
  double length = reach * (.5 + .5 * draw.unit());
  double dx = std::round(16 * length * std::cos(angle)) / 16, dy = std::round(16 * length * std::sin(angle)) / 16;
  shot = with(with(shot, "scene.pan_x", dx), "scene.pan_y", dy);
  if (const auto* samples = plan::paramOf(subject.pipeline, Role::SampleCount))
    shot = with(shot, samples->name, draw.whole(16, 33));
  std::shared_ptr<const plan::PipelineDesc> held = evaluated(subject, shot);
  const plan::PipelineDesc& now = *held;
  ExposureInterval window = windowOf(shot);
  double along = std::max(std::abs(dx), std::abs(dy));
  double samples = std::min(numberOf(now, Role::SampleCount, along), std::max(2.0, 2 * std::floor(along / 2)));
  double share = 1 / samples + .5 / along;
  // A pipeline with loops draws silhouettes between pixels, up to a pixel from the silhouettes of the sharp picture.
  int radius = now.loops.empty() ? 0 : 1;
  if (radius) shot = with(shot, "scene.cards", 1);  // as in brief()
  Picture sharp = subject.batch.color(subject.sharp(shot));
  auto at = [&](int x, int y, int c) -> std::optional<Right> {
    Right right{1e30, -1e30, 1e-4};
    for (int v = y - radius; v <= y + radius; ++v)
      for (int u = x - radius; u <= x + radius; ++u) {
        Mean mean = meanAlong(*sharp, u, v, dx, dy, window);
        if (!mean.inside) return std::nullopt;
        right.low = std::min(right.low, mean.color[size_t(c)]);
        right.high = std::max(right.high, mean.color[size_t(c)]);
        right.tolerance = std::max(right.tolerance, mean.variation[size_t(c)] * share + 1e-4);
      }
    return right;
  };
  return compare(*subject.batch.color(shot), at, {shot, subject.sharp(shot)});
}

// ---- linear, scaled

Finding linear(const CheckedCase& subject) {
  lab::Shot shot = without(subject.shot, {"lit"});
  if (subject.draw("linear").chance(.3)) {
    lab::Shot bright = with(shot, "scene.brightness", 3);
    Picture one = subject.batch.color(shot);
    auto at = [&](int x, int y, int c) { return exactly(3.0 * one->at(x, y, c), 1e-6 * 6); };
    return compare(*subject.batch.color(bright), at, {bright, shot});
  }
  lab::Shot first = with(shot, "scene.second", 0), second = with(shot, "scene.first", 0);
  Picture a = subject.batch.color(first), b = subject.batch.color(second);
  auto at = [&](int x, int y, int c) { return exactly(double(a->at(x, y, c)) + b->at(x, y, c), 2e-6); };
  return compare(*subject.batch.color(shot), at, {shot, first, second});
}

Finding scaled(const CheckedCase& subject) {
  Random draw = subject.draw("scaled");
  bool exact = draw.chance(.6);
  double scale = exact ? std::exp2(draw.whole(-19, 19)) : std::pow(10, draw.unit() * 11.6 - 5.8);
  lab::Shot shot = subject.shot, other = with(shot, "scene.scale", scale);
  if (exact) return same(subject, other, shot, 0);
  Picture one = subject.batch.color(shot), two = subject.batch.color(other);
  double tolerance = 1e-5 * std::max(1.0, image::largestColour(*one));
  int different = image::countDifferent(*one, *two, tolerance), allowed = std::max(1, one->width * one->height / 1000);
  if (different <= allowed) return {};
  Finding finding = same(subject, other, shot, tolerance);
  finding.excess = different - allowed;
  finding.text += fmt::format(", and {} pixels differ, at most {} may", different, allowed);
  return finding;
}

// ---- converging, unmasked

double errorOf(const CheckedCase& subject, const lab::Shot& shot, const std::vector<lab::Shot>& scenes) {
  double sum = 0;
  for (const lab::Shot& scene : scenes) {
    lab::Shot here = shot;
    here = with(here, "scene.seed", knob(scene, "seed", 1));
    lab::Shot truth = subject.truth(here, 96);
    sum += image::rootMeanSquaredError(*subject.batch.color(here), *subject.batch.color(truth));
  }
  return sum / double(scenes.size());
}

// The shot by another pipeline, with the values that both pipelines have and the values of `set`.
lab::Shot inCommon(const CheckedCase& subject, const lab::Shot& shot, const std::string& pipeline,
                   const std::vector<std::pair<std::string, plan::Value>>& set) {
  lab::Shot result = by(shot, pipeline);
  std::shared_ptr<const plan::PipelineDesc> own = evaluated(subject, shot), other = evaluated(subject, result);
  for (const auto& [name, value] : own->values)
    if (plan::paramNamed(*other, name)) result = with(result, name, value);
  for (const auto& [name, value] : set) result = with(result, name, value);
  return result;
}

Finding moreErrorThan(double error, double bound, const std::string& text, const std::vector<lab::Shot>& shots) {
  Finding finding;
  finding.shots = shots;
  finding.excess = error - bound;
  finding.holds = !(error > bound);
  finding.text = fmt::format("{}: error {:.5f}, at most {:.5f} is allowed", text, error, bound);
  return finding;
}

Finding converging(const CheckedCase& subject) {
  const plan::ParamDesc* samples = plan::paramOf(subject.pipeline, Role::SampleCount);
  if (!samples) return none();
  lab::Shot shot = without(subject.shot, {"lit", "spin"});
  shot = with(shot, "scene.wall", 1);
  double seed = knob(shot, "seed", 1);
  std::vector<lab::Shot> scenes = {shot, with(shot, "scene.seed", seed + 1)};
  lab::Shot few = with(shot, samples->name, 4), many = with(shot, samples->name, 32);
  double coarse = errorOf(subject, few, scenes), fine = errorOf(subject, many, scenes);
  Finding finding = moreErrorThan(fine, 1.1 * coarse + 1e-3, "32 samples compared with 4", {many, few});
  if (subject.pipeline.compare_with.empty() || !subject.is_base) return finding;
  lab::Shot other = inCommon(subject, many, subject.pipeline.compare_with, {});
  double theirs = errorOf(subject, other, scenes);
  return worse(finding, moreErrorThan(fine, 1.1 * theirs + 1e-3, "compared with " + subject.pipeline.compare_with,
                                      {many, other}));
}

// True if the shot sets a value of a node; another pipeline lacks the node.
bool setsNodes(const lab::Shot& shot) {
  return std::any_of(shot.sets.begin(), shot.sets.end(), [](const auto& s) {
    return s.first.find('.') != std::string::npos && !s.first.starts_with("scene.");
  });
}

bool isSet(const lab::Shot& shot, const std::string& name, const plan::Value& value) {
  return std::any_of(shot.sets.begin(), shot.sets.end(),
                     [&](const auto& s) { return s.first == name && plan::textOf(s.second) != plan::textOf(value); });
}

Finding unmasked(const CheckedCase& subject) {
  Finding worst = none();
  if (setsNodes(subject.shot)) return worst;
  for (const plan::EqualDesc& equal : subject.pipeline.equals) {
    lab::Shot shot = subject.shot;
    bool against = false;  // the equality changes a setting of the variant
    for (const auto& [name, value] : equal.when) {
      against = against || isSet(shot, name, value);
      shot = with(shot, name, value);
    }
    for (const auto& [name, value] : equal.set) against = against || isSet(shot, name, value);
    if (against || !subject.batch.accepts(shot.pipeline, shot.sets)) continue;
    lab::Shot other = inCommon(subject, shot, equal.pipeline, equal.set);
    if (!subject.batch.accepts(other.pipeline, other.sets)) continue;
    Finding finding = same(subject, shot, other, 0);
    worst = worst.applies ? worse(worst, finding) : finding;
  }
  return worst;
}

// ---- finite, permuted

Finding finite(const CheckedCase& subject) {
  // Times 3e38: finite, finite, infinity; negative: infinity times 0.
  const double factors[] = {1, 1.1, 1e6, -1e6};
  lab::Shot shot = with(without(subject.shot, {"lit"}), "scene.hot", 3e38);
  shot = with(shot, "scene.hot_scale", factors[subject.draw("finite").whole(0, 3)]);
  Picture sharp = subject.batch.color(subject.sharp(shot));
  auto at = [&](int x, int y, int c) -> std::optional<Right> {
    if (!std::isfinite(sharp->at(x, y, c))) return std::nullopt;
    double largest = std::numeric_limits<float>::max();
    return Right{-largest, largest, 0};
  };
  return compare(*subject.batch.color(shot), at, {shot});
}

Finding permuted(const CheckedCase& subject) {
  lab::Shot other = with(subject.shot, "scene.order", subject.draw("permuted").whole(1, 99));
  return same(subject, subject.shot, other, 0);
}

}  // namespace

const std::vector<Invariant>& invariants() {
  static const std::vector<Invariant> list = {
      {"constant", "a picture of one colour keeps this colour under any motion",
       "2 units in the last place per sample: each sample adds one rounding of its weight and one of the sum; "
       "subnormal numbers may become 0",
       constant},
      {"still", "without motion, or with an exposure of 0, the picture equals the sharp picture bit for bit",
       "none: nothing is computed", still},
      {"brief",
       "as the exposure approaches 0, the picture approaches the sharp picture: both are equal for displacements of "
       "1/16 px, which is less than the distance of any silhouette from a pixel centre; with 0.4 px no pixel leaves "
       "the range of its neighbours",
       "0.00001: the rounding of a mean", brief},
      {"mirrored",
       "a scene that is mirrored, flipped or turned by a half or a quarter gives the picture changed in the same way",
       "0.00001 of the brightest colour: light and projection are rounded differently", mirrored},
      {"shifted", "a scene moved by whole tiles (without tiles: by whole pixels) gives the moved picture",
       "none: every length in the scene is a sum of few powers of two", shifted},
      {"reversed", "time run backwards, with the raster time at the other end of the exposure, gives the same picture",
       "0.00001 of the brightest colour: sums are computed in the reverse order", reversed},
      {"convex", "no colour leaves the range of the colours of all layers in reach",
       "0.00001 of the brightest colour: weights add up to 1 except for rounding", convex},
      {"uniform",
       "if everything has the same displacement, the picture is the exact mean of the sharp picture along the motion",
       "per pixel, (1 / samples + 0.5 / displacement) times the sum of the steps along the motion: a sample represents "
       "its share of the exposure, jittered by up to half of this share, and a pixel represents the colours within "
       "half a pixel. The number of samples counts at most as the displacement in pixels",
       uniform},
      {"linear",
       "the picture of a sum of two lights is the sum of their pictures; three times the light gives three times "
       "the picture",
       "0.000002: three roundings of colours up to 3", linear},
      {"scaled",
       "a scene enlarged or shrunk as a whole gives the same picture, bit for bit if the factor is a power of two",
       "other factors: 0.1 % of the pixels, at silhouettes on pixel centres, may differ by more than 0.00001", scaled},
      {"converging",
       "the mean error of two scenes against ground truth is not larger with 32 samples than with 4, and not larger "
       "than the error of the pipeline in `compare_with`",
       "10 % and 0.001: the positions of a few samples at a silhouette are random", converging},
      {"unmasked",
       "under the conditions that a pipeline declares in `equals`, it equals the other pipeline bit for bit",
       "none: the same is computed", unmasked},
      {"finite",
       "with radiance up to the largest number, infinite or not a number, every pixel that is finite in the sharp "
       "picture stays finite",
       "none", finite},
      {"permuted", "the order of objects and triangles does not change the picture",
       "none: no two surfaces are equally far away", permuted},
  };
  return list;
}

const Invariant& invariantNamed(const std::string& name) {
  if (const Invariant* known = plan::find(invariants(), name)) return *known;
  throw Error(fmt::format("unknown invariant '{}'{}; known: {}", name, didYouMean(name, plan::invariantNames()),
                          fmt::join(plan::invariantNames(), ", ")),
              {}, 2);
}

}  // namespace strobe::stability
