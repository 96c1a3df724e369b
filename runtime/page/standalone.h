// SPDX-License-Identifier: MIT
// Figures as SVG files, for documents that cannot show inline SVG.
#pragma once

#include <string>

namespace strobe::page {

// Converts inline SVG of `svgOf` to an SVG file. The file has its style inside, with the colours of light pages and
// their background, and the size of the drawing.
std::string standaloneSvg(const std::string& svg);

}  // namespace strobe::page
