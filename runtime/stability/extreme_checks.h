// SPDX-License-Identifier: MIT
// What may be expected of a picture in an extreme case, by name (scripts/stability/extreme_cases.lua describes each).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/strict.h"
#include "lab/shot.h"

namespace strobe::stability {

class Probe;

struct ExtremeCheck {
  void (*holds)(Probe& probe, const ExtremeCheck& check) = nullptr;
  std::string by = "all";  // the methods it is about
  lab::Shot shot;
  std::optional<lab::Shot> other;
  // Only those that the check reads.
  double low = 0, high = 0, value = 0, tolerance = 0, tolerance_px = 0, share = 0;
  int pixels = 0;
  std::array<int, 2> pixel = {0, 0};
  std::string text;
  std::vector<double> exact;  // of each pixel a value, or x and y; NaN where anything is right
};

// Settings of a pipeline, or with the prefix "scene." of a scene.
void readSettings(const Json& table, const std::string& prefix, script::Settings& sets);

// `what` names the check in mistakes.
ExtremeCheck readCheck(const Json& json, const std::string& what, const Place& place, Problems& problems);

// Checks the picture by the method of the probe, if the check is about it.
void apply(const ExtremeCheck& check, Probe& probe);

}  // namespace strobe::stability
