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

// What the tooltip of a control says: description, range, what each choice does, who set it, where it is declared.
std::string tooltipOf(const lab::Control& control);

// Whether a search for `text` finds the control: every word of it in name, group, unit or description, in any case.
bool isFound(const lab::Control& control, const std::string& text);

// What a control is called in its own group: "depth_threshold" of "edge.depth_threshold".
std::string shortName(const lab::Control& control);

}  // namespace strobe::live
