// SPDX-License-Identifier: MIT
// Panel of controls: one widget per declaration, in groups that can be folded and searched.
#pragma once

#include "live/panels.h"
#include "live/widgets.h"

namespace strobe::live {

// Draws the value of the last slider as a bar along the slider's lower edge, so that the bar does not cover the text.
void slidePlace(const Widget& slider, double value);

void drawControls(const Fonts& fonts, Desk& desk, PanelState& state);

}  // namespace strobe::live
