// SPDX-License-Identifier: MIT
#include "oracle/gather_1d.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace strobe::oracle {
namespace {

double saturate(double x) { return std::clamp(x, 0.0, 1.0); }

double smoothStep(double from, double to, double x) {
  double t = saturate((x - from) / (to - from));
  return t * t * (3 - 2 * t);
}

const Texel& clampedAt(const Row& row, int x) { return row[std::clamp(x, 0, static_cast<int>(row.size()) - 1)]; }

// A place along the taps, from -1 at the end of the exposure to 1 at its start, remapped by a shutter curve.
double curvedPlace(double place, const TimeOf& time_of) { return time_of ? 1 - 2 * time_of((1 - place) / 2) : place; }

// Adds a displacement if it differs from all candidates by more than half a pixel and there is room.
void addCandidate(std::vector<double>& candidates, double d, size_t limit) {
  bool known = std::any_of(candidates.begin(), candidates.end(), [&](double c) { return std::abs(c - d) <= 0.5; });
  if (!known && candidates.size() < limit) candidates.push_back(d);
}

// The layers of one pixel's composite and the time samples it takes.
struct Composite {
  std::array<const Row*, 2> layers;
  std::vector<double> times;
  const Layered* options;

  const Texel* texel(const Row& layer, int y) const {
    return y >= 0 && y < static_cast<int>(layer.size()) && layer[y].valid ? &layer[y] : nullptr;
  }

  std::vector<double> candidatesAt(int x, double dominant) const {
    std::vector<double> candidates;
    auto add_at = [&](int y) {
      for (const Row* layer : layers)
        if (const Texel* t = texel(*layer, y)) addCandidate(candidates, t->d, options->candidates);
    };
    addCandidate(candidates, dominant, options->candidates);
    add_at(x);
    for (double t : times) {
      if (options->harvest) add_at(tapAt(x, -dominant * t));
      if (options->harvest && options->both_ways) add_at(tapAt(x, dominant * t));
    }
    return candidates;
  }

  // Nearest texel that lies at pixel x at time t, found by following the candidates back, or null.
  const Texel* nearestAt(int x, double t, const std::vector<double>& candidates) const {
    const Texel* nearest = nullptr;
    for (double g : candidates) {
      int y = tapAt(x, -g * t);
      double tolerance = std::max(0.75, std::abs(g) / (2 * options->samples));
      for (const Row* layer : layers) {
        int at = y;
        const Texel* found = texel(*layer, at);
        auto here = [&] { return found && std::abs(at + found->d * t - x) <= tolerance; };
        if (options->ask_twice && found && !here()) {
          at = tapAt(x, -found->d * t);
          found = texel(*layer, at);
        }
        if (here() && (!nearest || found->depth < nearest->depth)) nearest = found;
      }
    }
    return nearest;
  }
};

}  // namespace

Row rasterise(const Strips& strips, int width) {
  Row row;
  for (int x = 0; x < width; ++x) {
    Seen seen = seenAt(strips, x + 0.5, 0);
    row.push_back({seen.colour, 1.0 + seen.surface, strips[seen.surface].d, seen.surface, true});
  }
  return row;
}

int tapAt(int x, double offset) {
  int distance = static_cast<int>(std::floor(std::abs(offset) + 0.5));
  return offset < 0 ? x - distance : x + distance;
}

std::vector<double> meanJitters() {
  std::vector<double> jitters;
  for (int i = 0; i < 64; ++i) jitters.push_back((i + 0.5) / 64 - 0.5);
  return jitters;
}

std::vector<double> dominantDisplacement(const std::vector<const Row*>& layers, int tile, Window window) {
  int width = static_cast<int>(layers[0]->size());
  std::vector<double> tiles((width + tile - 1) / tile, 0.0);
  for (int x = 0; x < width; ++x)
    for (const Row* layer : layers)
      if (const Texel& texel = (*layer)[x]; texel.valid && std::abs(texel.d) > std::abs(tiles[x / tile]))
        tiles[x / tile] = texel.d;

  double largest = 0;
  for (double d : tiles) largest = std::max(largest, std::abs(d));
  int radius = static_cast<int>(std::ceil(largest * std::max(std::abs(window.open), std::abs(window.close)) / tile));

  std::vector<double> dominant(width, 0.0);
  for (int x = 0; x < width; ++x) {
    int first = std::max(x / tile - radius, 0);
    int last = std::min(x / tile + radius, static_cast<int>(tiles.size()) - 1);
    for (int i = first; i <= last; ++i)
      if (std::abs(tiles[i]) > std::abs(dominant[x])) dominant[x] = tiles[i];
  }
  return dominant;
}

double cone(double distance, double radius) { return saturate(1 - distance / radius); }

double cylinder(double distance, double radius) { return 1 - smoothStep(0.95 * radius, 1.05 * radius, distance); }

double softDepth(double za, double zb, double extent) { return saturate(1 - (zb - za) / extent); }

double mcguireAt(const Row& row, double dominant, int x, const McGuire& options) {
  // Spread of a point: half its displacement to either side, or its whole displacement to one side.
  double reach = options.one_sided ? 1 : 0.5;
  if (std::abs(dominant) * reach <= 0.5) return row[x].colour;
  double radius = std::max(std::abs(row[x].d) * reach, 0.5);
  double weight = 1 / radius;
  double sum = weight * row[x].colour;
  for (int i = 0; i < options.samples; ++i) {
    // The middle tap is the pixel itself, which is already counted.
    bool is_centre = std::abs(curvedPlace(0, options.time_of)) < 1e-9;
    if (!options.one_sided && is_centre && i == (options.samples - 1) / 2) continue;

    double t = curvedPlace(-1 + 2 * (i + options.jitter + 1) / (options.samples + 1), options.time_of);
    double offset = options.one_sided ? dominant * (t + 1) / 2 : dominant / 2 * t;
    int y = tapAt(x, offset);
    const Texel& tap = clampedAt(row, y);
    double distance = options.rounded_distance ? std::abs(y - x) : std::abs(offset);
    double tap_radius = std::max(std::abs(tap.d) * reach, 0.5);
    double in_front = softDepth(row[x].depth, tap.depth, options.soft_extent);
    double behind = softDepth(tap.depth, row[x].depth, options.soft_extent);
    double w = in_front * cone(distance, tap_radius) + behind * cone(distance, radius) +
               2 * cylinder(distance, tap_radius) * cylinder(distance, radius);
    weight += w;
    sum += w * tap.colour;
  }
  return sum / weight;
}

double guertinAt(const Row& row, double dominant, int x, const Guertin& options) {
  bool centred = options.window.open < 0 && options.window.close > 0;
  double share = centred ? 0.5 : 1;
  double length = std::abs(dominant) * share;
  if (length <= 0.505) return row[x].colour;
  auto sign = [](double d) { return double(d > 0) - double(d < 0); };
  auto spread = [&](double d) { return std::max(std::abs(d) * share, 0.5); };
  double radius = spread(row[x].d);
  double own = radius > 0.5 ? sign(row[x].d) : 0;  // v_c; a row has no second direction

  double weight = options.samples / (options.kappa * radius);
  double sum = weight * row[x].colour;
  for (int i = 0; i < options.samples; ++i) {
    bool is_centre = std::abs(curvedPlace(0, options.time_of)) < 1e-9;
    if (centred && is_centre && options.samples % 2 == 1 && i == options.samples / 2) continue;
    // One-sided samples are counted from the pixel outwards; after the raster time the jitter is reversed.
    bool after = options.window.open >= 0;
    double t = -1 + 2 * (i + (after ? -1 : 1) * options.eta * options.jitter + 1) / (options.samples + 1);
    t = after ? -curvedPlace(-t, options.time_of) : curvedPlace(t, options.time_of);
    bool along_own = options.two && i % 2 == 1;
    double direction = along_own ? own : sign(dominant);
    if (direction == 0) continue;
    double along = centred ? t * length : (t + 1) / 2 * length * (after ? -1 : 1);
    int y = tapAt(x, along * direction);
    const Texel& tap = clampedAt(row, y);
    double tap_d = options.uniform ? dominant : tap.d;
    double tap_radius = spread(tap_d);
    double distance = options.rounded_distance ? std::abs(y - x) : std::abs(along);

    double w_a = std::abs(own * direction), w_b = std::abs(sign(tap_d) * direction);
    double in_front = softDepth(row[x].depth, tap.depth, options.soft_extent);
    double behind = softDepth(tap.depth, row[x].depth, options.soft_extent);
    double both = std::min(radius, tap_radius);
    double covers = options.hard_cylinder ? double(distance < both) : cylinder(distance, both);
    double w = in_front * cone(distance, tap_radius) * w_b + behind * cone(distance, radius) * w_a +
               2 * covers * std::max(w_a, w_b);
    weight += w;
    sum += w * tap.colour;
  }
  return sum / weight;
}

namespace {

// The weight of a tap `offset` px (before rounding) and `s` steps away, in Jimenez' filter.
double rampWeight(const Texel& here, const Texel& tap, double dominant, double offset, double s,
                  const Paired& options) {
  bool centred = options.window.open < 0 && options.window.close > 0;
  double steps_per_pixel = options.samples / std::abs(dominant);
  auto spread = [&](double d) {
    return saturate(steps_per_pixel * std::abs(d) * (centred ? 0.5 : 1) - std::max(s - 1, 0.0));
  };
  double facing = 1;
  if (options.facing == Facing::kProjected) facing = std::min(std::abs(tap.d / dominant), 1.0);
  bool leaves = tap.d * offset * (options.window.open + options.window.close) > 0;
  if (options.facing == Facing::kOpposing && leaves) facing = 0;
  // Depths differ widely here, so the soft comparison is a hard one, 1/2 for equal depths.
  double behind = saturate(0.5 + 1000 * (tap.depth - here.depth));
  return behind * spread(here.d) + (1 - behind) * spread(tap.d) * facing;
}

double oneSidedRampAt(const Row& row, double dominant, int x, const Paired& options) {
  double sum = 0, weight = 0;
  for (int i = 0; i < options.samples; ++i) {
    double s = i + 0.5 + options.jitter;
    double offset = (options.window.open < 0 ? 1 : -1) * dominant * s / options.samples;
    const Texel& tap = clampedAt(row, tapAt(x, offset));
    double w = rampWeight(row[x], tap, dominant, offset, s, options);
    sum += w * tap.colour;
    weight += w;
  }
  return sum / options.samples + (1 - weight / options.samples) * row[x].colour;
}

}  // namespace

double pairedAt(const Row& row, double dominant, int x, const Paired& options) {
  bool centred = options.window.open < 0 && options.window.close > 0;
  if (std::abs(dominant) * (centred ? 0.5 : 1) <= 0.5) return row[x].colour;
  if (!centred) return oneSidedRampAt(row, dominant, x, options);

  double sum = 0, weight = 0;
  for (int i = 0; i < options.samples / 2; ++i) {
    double s = i + 0.5 + options.jitter;
    double offset = dominant * s / options.samples;
    std::array<const Texel*, 2> taps{&clampedAt(row, tapAt(x, offset)), &clampedAt(row, tapAt(x, -offset))};
    std::array<double, 2> w{rampWeight(row[x], *taps[0], dominant, offset, s, options),
                            rampWeight(row[x], *taps[1], dominant, -offset, s, options)};
    bool nearer = taps[0]->depth > taps[1]->depth;
    bool faster = std::abs(taps[1]->d) > std::abs(taps[0]->d);
    if (options.mirror && nearer && faster) w[0] = w[1];
    if (options.mirror && !nearer && !faster) w[1] = w[0];
    sum += w[0] * taps[0]->colour + w[1] * taps[1]->colour;
    weight += w[0] + w[1];
  }
  return sum / options.samples + (1 - weight / options.samples) * row[x].colour;
}

std::vector<bool> hiddenMask(const Row& raster, Mask mask, Window window) {
  int width = static_cast<int>(raster.size());
  std::vector<bool> hidden(width, false);
  if (mask == Mask::kNone) return hidden;
  for (int left = 0; left + 1 < width; ++left) {
    bool front_is_left = raster[left].depth < raster[left + 1].depth;
    const Texel& front = raster[front_is_left ? left : left + 1];
    const Texel& back = raster[front_is_left ? left + 1 : left];
    if (front.surface == back.surface) continue;

    double silhouette = left + 1;
    for (int y = 0; y < width; ++y) {
      if (raster[y].surface != front.surface) continue;
      double d = raster[y].d - (mask == Mask::kRelative ? back.d : 0);
      for (double t : {window.open, window.close}) {
        double end = y + 0.5 - d * t;
        if (y + 0.5 < silhouette ? end >= silhouette : end < silhouette) hidden[y] = true;
      }
    }
  }
  return hidden;
}

Row reveal(const Strips& strips, const Row& raster, const std::vector<bool>& mask) {
  Row revealed = raster;
  for (int x = 0; x < static_cast<int>(raster.size()); ++x) {
    revealed[x].valid = mask[x];
    if (!mask[x]) continue;
    int skipped = raster[x].surface + 1;
    Seen seen = seenAt(Strips(strips.begin() + skipped, strips.end()), x + 0.5, 0);
    int surface = seen.surface + skipped;
    revealed[x] = {seen.colour, 1.0 + surface, strips[surface].d, surface, true};
  }
  return revealed;
}

LayeredResult gatherLayered(const Row& raster, const Row& revealed, const Layered& options, Window window) {
  Composite composite{{&raster, &revealed}, {}, &options};
  for (int i = 0; i < options.samples; ++i)
    composite.times.push_back(window.close -
                              (window.close - window.open) * (i + 0.5 + options.jitter) / options.samples);

  std::vector<double> dominant = dominantDisplacement({&raster, &revealed}, options.tile, window);
  LayeredResult result;
  for (int x = 0; x < static_cast<int>(raster.size()); ++x) {
    auto candidates = composite.candidatesAt(x, dominant[x]);
    double sum = 0;
    int fallbacks = 0;
    for (double t : composite.times) {
      const Texel* texel = composite.nearestAt(x, t, candidates);
      if (!texel) ++fallbacks;
      if (!texel) texel = revealed[x].valid ? &revealed[x] : &raster[x];
      sum += texel->colour;
    }
    result.colour.push_back(sum / options.samples);
    result.fallbacks.push_back(fallbacks);
  }
  return result;
}

double alphaOverAt(const Strips& strips, Window window, int pixel) {
  Strips behind(strips.begin() + 1, strips.end());
  Strips before_black{strips[0], Strip{}};
  Exposure front = exposeCentre(before_black, window, pixel);
  return front.colour + (1 - front.coverage) * exposeCentre(behind, window, pixel).colour;
}

double sampledAt(const Strips& strips, Window window, int samples, int pixel) {
  double sum = 0;
  for (int i = 0; i < samples; ++i)
    sum += seenAt(strips, pixel + 0.5, window.open + (window.close - window.open) * (i + 0.5) / samples).colour;
  return sum / samples;
}

Strips StripedBar::strips() const { return {{left, left + 64, d_front, front}, {-kInfinity, kInfinity, d_back, back}}; }

RowError layeredError(const StripedBar& bar, Mask mask, const Layered& options, Window window) {
  constexpr int kMargin = 45;
  Strips strips = bar.strips();
  Row raster = rasterise(strips, static_cast<int>(bar.left) + 64 + 128);
  Row revealed = reveal(strips, raster, hiddenMask(raster, mask, window));
  LayeredResult result = gatherLayered(raster, revealed, options, window);

  RowError error;
  int first = static_cast<int>(bar.left) - kMargin, last = static_cast<int>(bar.left) + 64 + kMargin;
  for (int x = first; x < last; ++x) {
    double e = result.colour[x] - exposeCentre(strips, window, x).colour;
    error.rms += e * e / (last - first);
    error.max = std::max(error.max, std::abs(e));
    error.fallbacks += result.fallbacks[x];
  }
  error.rms = std::sqrt(error.rms);
  return error;
}

}  // namespace strobe::oracle
