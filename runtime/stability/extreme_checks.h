// SPDX-License-Identifier: MIT
// Checks of a picture in an extreme case, by name (scripts/stability/extreme_cases.lua describes each).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/json_fwd.h"
#include "lab/shot.h"

namespace strobe::stability {

class Probe;

// One check of an extreme case: the test function, the shots to draw, and the expected values and tolerances.
struct ExtremeCheck {
  void (*holds)(Probe& probe, const ExtremeCheck& check) = nullptr;
  std::string by = "all";  // methods to check
  lab::Shot shot;
  std::optional<lab::Shot> other;
  // Set only if the check reads them.
  double low = 0, high = 0, value = 0, tolerance = 0, tolerance_px = 0, share = 0;
  int pixels = 0;
  std::array<int, 2> pixel = {0, 0};
  std::string text;
  std::vector<double> exact;  // one value, or x and y, per pixel; NaN: any value passes
};

// Reads settings of a pipeline; with the prefix "scene.", settings of a scene.
void readSettings(const Json& table, const std::string& prefix, script::Settings& sets);

// Reads a check of scripts/stability/extreme_cases.lua. Throws an exception of the JSON library if a required key is
// missing or has another type.
ExtremeCheck readCheck(const Json& json);

// Checks the picture of the probe's method, if `check.by` includes the method.
void apply(const ExtremeCheck& check, Probe& probe);

}  // namespace strobe::stability
