// SPDX-License-Identifier: MIT
// Painted patterns that are kept on disk for later runs. The patterns of a room take longer to paint than its picture
// to render.
#pragma once

#include "base/files.h"
#include "scene/textures.h"

namespace strobe::scene {

// Returns a painter that reads and writes patterns in "textures" below `folder`. Programs built from the same painting
// code share them. An empty `folder` disables the cache.
Painter keptPainter(const Path& folder);

}  // namespace strobe::scene
