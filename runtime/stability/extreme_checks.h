// SPDX-License-Identifier: MIT
// What extreme cases are made of: shots of the scenes below scripts/scenes, and what may be expected of their pictures.
#pragma once

#include <functional>

#include "stability/extremes.h"

namespace strobe::stability::extreme {

struct Setting {
  const char* name;
  double value;
};

// A scene at frame 0 with these values of its parameters.
lab::Shot shotOf(const std::string& scene, int width, int height, const std::vector<Setting>& settings = {});
// With settings of the pipelines that have them.
lab::Shot set(lab::Shot shot, const std::vector<std::pair<std::string, std::string>>& settings);
lab::Shot anchored(lab::Shot shot, const std::string& anchor);
// The room that is moved, scaled and sped up (scenes/stability/extreme.lua).
lab::Shot room(const std::vector<Setting>& settings = {});

const image::Image& colorIn(const lab::Picture& picture);
bool warnedOf(const lab::Picture& picture, const std::string& text);

// Bit for bit what the capture sees.
void expectSharp(Probe& probe, const lab::Shot& shot);
// The same but for silhouettes that cross sample positions by rounding, which rays and raster see differently.
void expectSharpBut(Probe& probe, const lab::Shot& shot, int pixels);
// Weights are not negative and add up to 1: nothing leaves the range of what there is to see.
void expectWithin(Probe& probe, const lab::Shot& shot, double low, double high);
// A filter is worth its name where it brings the picture nearer to truth.
void expectNearerToTruth(Probe& probe, const lab::Shot& shot);
// The other shot shows the same: at most `share` of the pixels may differ by more than `tolerance`.
void expectSame(Probe& probe, const lab::Shot& shot, const lab::Shot& other, double tolerance, double share);

// The displacement image against its closed form at pixel coordinates, px, within a share of it and `tolerance_px`; NaN
// leaves a pixel out.
using PathAt = std::function<dvec2(double x, double y)>;
void expectPath(Probe& probe, const lab::Shot& shot, const PathAt& right, double share, double tolerance_px);

// Truth's red channel against a closed form, with the bound of its midpoint times.
using ValueAt = std::function<double(int x, int y)>;
void expectTruth(Probe& probe, const lab::Shot& shot, const ValueAt& right, double bound);

// The cases, by what they are about.
void addDisplacements(std::vector<Extreme>& list);
void addSizes(std::vector<Extreme>& list);
void addExposures(std::vector<Extreme>& list);
void addPlaces(std::vector<Extreme>& list);
void addCameras(std::vector<Extreme>& list);
void addExtents(std::vector<Extreme>& list);
void addSurfaces(std::vector<Extreme>& list);

}  // namespace strobe::stability::extreme
