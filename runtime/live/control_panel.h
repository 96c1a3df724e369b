// SPDX-License-Identifier: MIT
// The panel of controls: one widget per declaration, in groups that can be folded and searched.
#pragma once

#include "live/panels.h"
#include "live/widgets.h"

namespace strobe::live {

// The place of the value of the slider drawn last, as a bar along its lower edge: the text stands free above it.
void slidePlace(const Widget& slider, double value);

void drawControls(const Fonts& fonts, Desk& desk, PanelState& state);

}  // namespace strobe::live
