// SPDX-License-Identifier: MIT
// Figures as files, for documents that show pictures but no inline SVG.
#pragma once

#include <string>

namespace strobe::page {

// The SVG file of what `svgOf` makes: its style is inside, with the colours of light pages on their background, and it
// has the size that it was drawn for.
std::string standaloneSvg(const std::string& svg);

}  // namespace strobe::page
