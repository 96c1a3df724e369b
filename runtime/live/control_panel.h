// SPDX-License-Identifier: MIT
// The panel of controls: one widget per declaration, in groups that can be folded and searched.
#pragma once

#include "live/panels.h"

namespace strobe::live {

void drawControls(const Fonts& fonts, Desk& desk, PanelState& state);

}  // namespace strobe::live
