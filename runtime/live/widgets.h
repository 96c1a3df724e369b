// SPDX-License-Identifier: MIT
// Widget of a control, chosen by the control's declaration alone.
#pragma once

#include <string>

#include "lab/session.h"

namespace strobe::live {

// Kind of input widget for a control, such as checkbox, slider or drop-down list, with its limits, scale and number
// format.
struct Widget {
  enum class Kind { Checkbox, IntSlider, IntDrag, FloatSlider, FloatDrag, Combo, Text };
  Kind kind = Kind::Text;
  double low = 0, high = 0;  // ends of a slider; equal for a drag without limits
  bool logarithmic = false;
  std::string format;  // of a number, as ImGui format: "%.4g px"
};
Widget widgetOf(const plan::ParamDesc& declaration);

// "312 of 4096 samples"; without `of` if `have` is at least `of`.
std::string samplesText(int have, int of);

// Position of a value on a slider, from 0 (low) to 1 (high).
double shareOf(const Widget& slider, double value);

// True if a number stands for "not set", because it is below the declared minimum.
bool isOpen(const plan::ParamDesc& declaration, double value);

// Tooltip of a control: description, range, choices with their meanings, value and origin, reason if idle, place of the
// declaration.
std::string tooltipOf(const lab::Control& control);

// True if every word of `text` occurs in the control's name, group, unit or description; not case-sensitive.
bool isFound(const lab::Control& control, const std::string& text);

// Name of a control in its own group: "depth_threshold" for "edge.depth_threshold".
std::string shortName(const lab::Control& control);

}  // namespace strobe::live
