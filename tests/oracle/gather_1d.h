// SPDX-License-Identifier: MIT
// The gathers along one row of pixels, in double precision and independent of the shaders: what each published filter
// must produce on a picture that a person can check. Conventions are those of closed_form.h.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "oracle/closed_form.h"

namespace strobe::oracle {

// What a gather knows about one pixel of one layer. Greater depth is farther.
struct Texel {
  double colour = 0;
  double depth = 0;
  double d = 0;  // px over the exposure
  int surface = 0;
  bool valid = true;
};
using Row = std::vector<Texel>;

// The strips at the capture, sampled at pixel centres; the depth of a strip is 1 + its place in the list.
Row rasterise(const Strips& strips, int width);

// The pixel x + offset, rounded to the nearest one; halves go away from x, so that a mirrored row gives a mirrored
// result.
int tapAt(int x, double offset);

// 64 jitters at the middles of 64 equal parts of [-1/2, 1/2]; their mean stands for the mean over all jitters.
std::vector<double> meanJitters();

// Per pixel, the displacement of largest length in the tiles around: `tile` px wide, as many to either side as the
// largest displacement can reach in the window. Of equal lengths the first in the row wins.
// `layers` are read at each pixel in their order.
std::vector<double> dominantDisplacement(const std::vector<const Row*>& layers, int tile, Window window);

// Of a shutter curve: the time before which a share of the weight lies, both in [0, 1] from the opening; none: even.
using TimeOf = std::function<double(double share)>;

// --- McGuire, Hennessy, Bukowski and Osman 2012, "A Reconstruction Filter for Plausible Motion Blur" ---

struct McGuire {
  int samples = 15;
  double jitter = 0;             // in [-1/2, 1/2]
  double soft_extent = 0.1;      // depth over which two surfaces count as one
  bool one_sided = false;        // taps on [x, x + d], all of them kept, spread |d|, instead of [x - d/2, x + d/2]
  bool rounded_distance = true;  // of a tap: between the centres of the two pixels
  TimeOf time_of = {};
};
double mcguireAt(const Row& row, double dominant, int x, const McGuire& options);

double cone(double distance, double radius);
double cylinder(double distance, double radius);
double softDepth(double za, double zb, double extent);

// --- Guertin, McGuire and Nowrouzezahrai 2014, "A Fast and Stable Feature-Aware Motion Blur Filter" ---
// Along one row there is nothing to look at across it: where a pixel is at rest every other sample is left out.

struct Guertin {
  int samples = 16;
  double jitter = 0;  // in [-1/2, 1/2]
  Window window = kCentreAnchor;
  bool two = true;    // every other sample along the pixel's own direction
  double kappa = 40;  // the pixel itself weighs samples / (kappa * spread)
  double eta = 0.95;  // share of the jitter that is used
  double soft_extent = 0.1;
  bool uniform = false;  // all are taken to move like the dominant displacement
  // The edits of McGuire's filter that preceded it: a cylinder without soft border, distances between pixels.
  bool hard_cylinder = false;
  bool rounded_distance = false;
  TimeOf time_of = {};
};
double guertinAt(const Row& row, double dominant, int x, const Guertin& options);

// --- Jimenez 2014, "Next Generation Post Processing in Call of Duty: Advanced Warfare" ---
// As its public descendants implement it.

enum class Facing {
  kAny,
  kProjected,  // what a tap spreads counts by its displacement along the dominant one, as a share of that
  kOpposing,   // ... not at all if it never comes here
};

struct Paired {
  int samples = 16;    // even; pairs lie at equal distance to either side of the pixel
  double jitter = 0;   // in [-1/2, 1/2], in steps
  bool mirror = true;  // the nearer and faster side decides the weight of both
  Facing facing = Facing::kAny;
  // With the capture in the middle of the window. Else single taps lie on the one side, and a point spreads over all of
  // its displacement instead of half of it to either side.
  Window window = kCentreAnchor;
};
double pairedAt(const Row& row, double dominant, int x, const Paired& options);

// --- Two layers, one foreground ---

enum class Mask {
  kNone,
  kOwn,       // along the foreground's own displacement (Tan, Cui and Bhojan 2020)
  kRelative,  // along its displacement relative to the surface beyond the silhouette
};

// The foreground pixels that move off their surface somewhere in the window: those for which a path of the mask's kind
// crosses a silhouette. Only silhouettes between neighbouring pixels with a farther surface on the other side count.
std::vector<bool> hiddenMask(const Row& raster, Mask mask, Window window);

// What the strips behind the frontmost one show, valid where the mask is set.
Row reveal(const Strips& strips, const Row& raster, const std::vector<bool>& mask);

struct Layered {
  int samples = 32;
  double jitter = 0;
  int tile = 20;
  bool harvest = true;     // also consider the displacements met at the taps along the dominant one
  bool both_ways = false;  // ... and at the taps in the opposite direction
  bool ask_twice = false;  // a texel that is not at the pixel leads to a second guess, by its own displacement
  std::size_t candidates = 4;
};

struct LayeredResult {
  std::vector<double> colour;
  std::vector<int> fallbacks;  // per pixel, the time samples for which no layer had anything
};

// Per time sample, the nearest texel of either layer that really is at the pixel at that time. Exact up to sampling and
// rounding when the layers hold everything that is seen.
LayeredResult gatherLayered(const Row& raster, const Row& revealed, const Layered& options, Window window);

// What blurring two perfect layers apart and laying one over the other tends to: the foreground's light plus the share
// of time it is not there times the mean of what is behind it. Right only where the two do not vary together.
double alphaOverAt(const Strips& strips, Window window, int pixel);

// The mean of the colours seen at the middles of `samples` equal parts of the window: what an error-free method with
// that many time samples gives.
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

// Over the bar and 45 px to either side of it.
struct RowError {
  double rms = 0;
  double max = 0;
  int fallbacks = 0;
};
RowError layeredError(const StripedBar& bar, Mask mask, const Layered& options, Window window);

}  // namespace strobe::oracle
