// SPDX-License-Identifier: MIT
// Which widget shows a control, from its declaration alone.
#pragma once

#include <string>

#include "lab/session.h"

namespace strobe::live {

struct Widget {
  enum class Kind { Checkbox, IntSlider, IntDrag, FloatSlider, FloatDrag, Combo, Text };
  Kind kind = Kind::Text;
  double low = 0, high = 0;  // of sliders; of drags, equal where there is no limit
  bool logarithmic = false;
  std::string format;  // of numbers, as ImGui takes it: "%.4g px"
};
Widget widgetOf(const plan::ParamDesc& declaration);

// "312 of 4096 samples"; "5000 samples" where there are as many as there need be.
std::string samplesText(int have, int of);

// Place of a value on a slider, 0 (low) to 1.
double shareOf(const Widget& slider, double value);

// True if a number stands for "not set": it is below the declared minimum.
bool isOpen(const plan::ParamDesc& declaration, double value);

// Tooltip of a control: description, range, choices with their meanings, value and origin, why it is idle, its place.
std::string tooltipOf(const lab::Control& control);

// Whether a search for `text` finds the control: every word of it in name, group, unit or description, in any case.
bool isFound(const lab::Control& control, const std::string& text);

// What a control is called in its own group: "depth_threshold" of "edge.depth_threshold".
std::string shortName(const lab::Control& control);

}  // namespace strobe::live
