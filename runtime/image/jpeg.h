// SPDX-License-Identifier: MIT
// JPEG files of display images, for pages that would be too large with PNG. Small and lossy.
#pragma once

#include <string>

#include "image/image.h"

namespace strobe::image {

// `display` has 1 or 3 channels of sRGB-encoded values, which are clamped. `quality` is 1 to 100. Equal arguments give
// equal bytes.
std::string encodeJpeg(const Image& display, int quality);

}  // namespace strobe::image
