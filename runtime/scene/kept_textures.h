// SPDX-License-Identifier: MIT
// Painted patterns kept on disk from run to run: a room's take longer to paint than its picture to render.
#pragma once

#include "base/files.h"
#include "scene/textures.h"

namespace strobe::scene {

// Paints a pattern that it has not painted before, this program or another built of the same painting. Keeps them in
// "textures" below `folder`; an empty name keeps nothing.
Painter keptPainter(const Path& folder);

}  // namespace strobe::scene
