// SPDX-License-Identifier: MIT
// The published gathers along one row of pixels, in double precision and independent of the shaders. A row is small
// enough to check by hand. Conventions as in closed_form.h.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "oracle/closed_form.h"

namespace strobe::oracle {

// One pixel of one layer, as the gathers read it. Greater depth is farther.
struct Texel {
  double colour = 0;
  double depth = 0;
  double d = 0;  // px over the exposure
  int surface = 0;
  bool valid = true;
};
using Row = std::vector<Texel>;

// The strips at the raster time, sampled at pixel centres. The depth of a strip is 1 + its index.
Row rasterise(const Strips& strips, int width);

// The pixel nearest to x + offset. Halves round away from x, so a mirrored row gives a mirrored result.
int tapAt(int x, double offset);

// 64 jitters at the middles of 64 equal parts of [-1/2, 1/2]; their mean stands for the mean over all jitters.
std::vector<double> meanJitters();

// Longest displacement in the tiles around each pixel. Tiles are `tile` px wide; the largest displacement within the
// window sets the number of tiles to either side. Of equal lengths the first in the row wins. `layers` are read at each
// pixel in their order.
std::vector<double> dominantDisplacement(const std::vector<const Row*>& layers, int tile, Window window);

// Inverse shutter curve: the time before which a share of the weight lies. Share and time are in [0, 1] from shutter
// opening; empty for an even shutter.
using TimeOf = std::function<double(double share)>;

// --- McGuire, Hennessy, Bukowski and Osman 2012, "A Reconstruction Filter for Plausible Motion Blur" ---

struct McGuire {
  int samples = 15;
  double jitter = 0;             // in [-1/2, 1/2]
  double soft_extent = 0.1;      // range of the soft depth comparison
  bool one_sided = false;        // taps on [x, x + d] instead of [x - d/2, x + d/2], none left out; spread |d|
  bool rounded_distance = true;  // tap distances are between pixel centres
  TimeOf time_of = {};
};
double mcguireAt(const Row& row, double dominant, int x, const McGuire& options);

double cone(double distance, double radius);
double cylinder(double distance, double radius);
double softDepth(double za, double zb, double extent);

// --- Guertin, McGuire and Nowrouzezahrai 2014, "A Fast and Stable Feature-Aware Motion Blur Filter" ---
// A row has one direction only, so a static pixel takes every other sample only.

struct Guertin {
  int samples = 16;
  double jitter = 0;  // in [-1/2, 1/2]
  Window window = kCentreAnchor;
  bool two = true;    // every other sample along the pixel's own direction
  double kappa = 40;  // the pixel itself weighs samples / (kappa * spread)
  double eta = 0.95;  // share of the jitter that is used
  double soft_extent = 0.1;
  bool uniform = false;  // every tap has the dominant displacement
  // The edits of McGuire's filter that preceded it: a cylinder without soft border, distances between pixels.
  bool hard_cylinder = false;
  bool rounded_distance = false;
  TimeOf time_of = {};
};
double guertinAt(const Row& row, double dominant, int x, const Guertin& options);

// --- Jimenez 2014, "Next Generation Post Processing in Call of Duty: Advanced Warfare" ---
// Implemented as in its public descendants.

enum class Facing {
  kAny,
  kProjected,  // weight scaled by |d| / |dominant displacement|, at most 1
  kOpposing,   // weight 0 for a tap that never reaches the pixel
};

struct Paired {
  int samples = 16;    // even; pairs lie at equal distance to either side of the pixel
  double jitter = 0;   // in [-1/2, 1/2], in steps
  bool mirror = true;  // the nearer and faster side decides the weight of both
  Facing facing = Facing::kAny;
  // With the raster time inside the window, taps lie on both sides. With a one-sided window they lie on one side, and a
  // point spreads over its whole displacement to that side.
  Window window = kCentreAnchor;
};
double pairedAt(const Row& row, double dominant, int x, const Paired& options);

// --- Two layers, one foreground ---

enum class Mask {
  kNone,
  kOwn,       // along the foreground's own displacement (Tan, Cui and Bhojan 2020)
  kRelative,  // along the displacement relative to the surface beyond the silhouette
};

// Marks foreground pixels whose path, of the mask's kind, crosses a silhouette within the window. A silhouette lies
// between neighbouring pixels of different surfaces.
std::vector<bool> hiddenMask(const Row& raster, Mask mask, Window window);

// The strips behind the frontmost one at the raster time; valid where the mask is set.
Row reveal(const Strips& strips, const Row& raster, const std::vector<bool>& mask);

struct Layered {
  int samples = 32;
  double jitter = 0;
  int tile = 20;
  bool harvest = true;     // also take candidates at the taps along the dominant displacement
  bool both_ways = false;  // ... and at the taps in the opposite direction
  bool ask_twice = false;  // a texel that misses the pixel starts a second search with its own displacement
  std::size_t candidates = 4;
};

struct LayeredResult {
  std::vector<double> colour;
  std::vector<int> fallbacks;  // per pixel, number of time samples that no layer resolves
};

// Per time sample, takes the nearest texel of either layer that lies at the pixel at that time. If the layers hold
// every visible surface, the only errors are sampling and rounding.
LayeredResult gatherLayered(const Row& raster, const Row& revealed, const Layered& options, Window window);

// Limit of alpha-over of two perfectly blurred layers: the foreground's light, plus the share of time without
// foreground times the mean of the background. Exact only if foreground and background do not vary together.
double alphaOverAt(const Strips& strips, Window window, int pixel);

// Mean of the colours at the middles of `samples` equal parts of the window: the result of an error-free method with
// that many time samples.
double sampledAt(const Strips& strips, Window window, int samples, int pixel);

// --- The scene of the layered composite ---

// A striped bar [left, left + 64) that moves by d_front over a striped background that moves by d_back.
struct StripedBar {
  double left = 128;
  Pattern front{0.9, 0.6, 8, 128};
  Pattern back{0.4, 0.1, 8, 128};
  double d_front = 0;
  double d_back = 0;

  Strips strips() const;
};

// Errors over the bar and 45 px to either side.
struct RowError {
  double rms = 0;
  double max = 0;
  int fallbacks = 0;
};
RowError layeredError(const StripedBar& bar, Mask mask, const Layered& options, Window window);

}  // namespace strobe::oracle
